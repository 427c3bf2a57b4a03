#include "environment/environment.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace lambent::environment {
namespace {

// The same picture at another size, texels at bilinear positions.
Panorama resized(const Panorama& from, int width, int height)
{
    image::RadianceImage image{width, height, 3, {}};
    image.values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double u = (x + 0.5) * from.width / width - 0.5, v = (y + 0.5) * from.height / height - 0.5;
            const int x0 = static_cast<int>(std::floor(u)), y0 = static_cast<int>(std::floor(v));
            const float fx = static_cast<float>(u - x0), fy = static_cast<float>(v - y0);
            const auto at = [&](int i, int j) {
                return from.radiance((i + from.width) % from.width, std::clamp(j, 0, from.height - 1));
            };
            const Rgb a = at(x0, y0), b = at(x0 + 1, y0), c = at(x0, y0 + 1), d = at(x0 + 1, y0 + 1);
            const auto blend = [&](float Rgb::*channel) {
                return (a.*channel * (1 - fx) + b.*channel * fx) * (1 - fy) +
                       (c.*channel * (1 - fx) + d.*channel * fx) * fy;
            };
            float* out = image.pixel(x, y);
            out[0] = blend(&Rgb::r), out[1] = blend(&Rgb::g), out[2] = blend(&Rgb::b);
        }
    return make_panorama(image);
}

// A sum over texels takes each for a point; texels as wide as the sky have to be divided before.
IrradianceMap irradiance_of(const Panorama& panorama)
{
    constexpr int least_width = 64, least_height = 32;
    if (panorama.width >= least_width && panorama.height >= least_height)
        return make_irradiance_map(panorama);
    return make_irradiance_map(
        resized(panorama, std::max(panorama.width, least_width), std::max(panorama.height, least_height)));
}

} // namespace

std::vector<Panorama> mip_chain(const Panorama& panorama)
{
    const int width = static_cast<int>(std::bit_ceil(static_cast<unsigned>(panorama.width)));
    const int height = static_cast<int>(std::bit_ceil(static_cast<unsigned>(panorama.height)));
    std::vector<Panorama> chain;
    chain.push_back(width == panorama.width && height == panorama.height ? panorama
                                                                         : resized(panorama, width, height));
    while (chain.back().height > 1 && chain.back().width > 1)
        chain.push_back(halved(chain.back()));
    return chain;
}

Environment make_environment(Panorama panorama)
{
    Environment environment;
    Blurs blurs;
    tbb::parallel_invoke([&] { blurs = make_blurs(panorama); },
                         [&] { environment.irradiance = irradiance_of(panorama); });
    environment.chain = std::move(blurs.chain);
    environment.lamps = std::move(blurs.lamps);
    environment.panorama = std::move(panorama);
    return environment;
}

} // namespace lambent::environment
