#include "environment/environment.h"

#include "environment/chain/make_chain.h"
#include "environment/panorama/resized.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace lambent::environment {
namespace {

// The sum over texels treats each as a point, so panoramas of few, large texels are enlarged first.
IrradianceMap irradiance_of(const Panorama& panorama)
{
    return make_irradiance_map(at_least(panorama, 64, 32));
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
