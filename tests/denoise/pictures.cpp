#include "tests/denoise/pictures.h"

#include <cmath>

namespace lambent::denoise::test {
namespace {

float as_float(double a)
{
    return static_cast<float>(a);
}

} // namespace

Rgb filled(std::size_t size, float value)
{
    return {Plane(size, value), Plane(size, value), Plane(size, value)};
}

Picture make_wall(int width, int height)
{
    const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    Picture picture;
    picture.width = width;
    picture.height = height;
    picture.guides = {Plane(size, 1.0f),
                      {Plane(size), Plane(size), Plane(size, 1.0f)},
                      Plane(size, 3.0f),
                      Plane(size, 0.25f),
                      Plane(size)};
    picture.count = Plane(size, 4.0f);
    for (Light* light : {&picture.diffuse, &picture.specular}) {
        light->exact = filled(size, 0.0f);
        light->halves = {Half{filled(size, 0.0f), filled(size, 0.0f)},
                         Half{filled(size, 0.0f), filled(size, 0.0f)}};
    }
    picture.diffuse.albedo = filled(size, 0.5f);
    return picture;
}

void sample_light(const Picture& picture, Light& light, const Share& visible, const Noise& noise,
                  double bounced)
{
    std::mt19937 random(noise.seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (Half& half : light.halves) {
                const std::size_t i = index_of(picture, x, y);
                const int samples = static_cast<int>(picture.count[i]) / 2;
                double unshadowed = 0.0, found = 0.0, blocked = 0.0;
                for (int s = 0; s < samples; ++s) {
                    double carried = 1.0 + noise.unshadowed * (2.0 * uniform(random) - 1.0);
                    if (noise.rarity > 0.0)
                        carried = uniform(random) < 1.0 / noise.rarity ? noise.rarity * carried : 0.0;
                    const bool arrives = uniform(random) < visible(x, y);
                    unshadowed += carried / samples;
                    found += (arrives ? carried : 0.0) / samples;
                    blocked += (arrives ? 0.0 : 1.0) / samples;
                }
                for (std::size_t c = 0; c < 3; ++c) {
                    const auto exact = static_cast<double>(light.exact[c][i]);
                    half.unshadowed[c][i] = as_float(exact * unshadowed);
                    half.found[c][i] = as_float(exact * found + bounced * blocked);
                }
            }
}

Picture make_mixture(int width, int height, std::uint32_t seed)
{
    Picture picture = make_wall(width, height);
    Guides& guides = picture.guides;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t i = index_of(picture, x, y);
            const bool near = std::hypot(x - 0.3 * width, y - 0.5 * height) < 0.25 * height;
            const double bend = 0.01 * x;
            guides.depth[i] = near ? 2.0f + 0.004f * static_cast<float>(y) : as_float(4.0 + 0.0003 * x * x);
            guides.normal[0][i] = near ? 0.0f : as_float(std::sin(bend));
            guides.normal[2][i] = near ? 1.0f : as_float(std::cos(bend));
            guides.alpha[i] = y > height / 2 ? 0.3f : as_float(0.02 + 0.001 * x);
            guides.metalness[i] = x > width / 2 ? 1.0f : 0.0f;
            guides.coverage[i] = uniform(random) < 0.05f ? 0.0f : uniform(random) < 0.1f ? 0.4f : 1.0f;
            picture.count[i] = uniform(random) < 0.2f ? 8.0f : 4.0f;
            for (std::size_t c = 0; c < 3; ++c) {
                picture.diffuse.albedo[c][i] = (x / 4 + y / 4) % 2 == 0 ? 0.8f : c == 1 ? 0.0f : 0.1f;
                picture.diffuse.exact[c][i] =
                    picture.diffuse.albedo[c][i] * as_float(0.6 + 0.4 * std::sin(0.1 * x + 0.05 * y));
                picture.specular.exact[c][i] =
                    as_float(0.3 + 0.2 * std::cos(0.07 * y + static_cast<double>(c)));
            }
        }
    const Share visible = [&](int x, int y) { return 0.5 + 0.5 * std::tanh(0.2 * (x - y)); };
    sample_light(picture, picture.diffuse, visible, {seed + 1, 0.5, 0.0});
    sample_light(picture, picture.specular, visible, {seed + 2, 0.5, 0.0}, 0.05);
    return picture;
}

double rms_difference(const Rgb& a, const std::function<double(int x, int y, int channel)>& b, int width)
{
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < a[c].size(); ++i) {
            const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
            const double d = static_cast<double>(a[c][i]) - b(x, y, static_cast<int>(c));
            sum += d * d;
        }
    return std::sqrt(sum / (3.0 * static_cast<double>(a[0].size())));
}

} // namespace lambent::denoise::test
