#include "apps/common/denoise_reference.h"

#include "denoise/statistical_filter.h"
#include "reference/samples/estimate.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lambent::cli {
namespace {

void resize(denoise::NoisyPicture& picture, std::size_t size)
{
    for (denoise::Plane* plane : {&picture.freedom, &picture.coverage, &picture.depth})
        plane->resize(size);
    for (denoise::Rgb* planes :
         {&picture.light, &picture.variance, &picture.emitted, &picture.albedo, &picture.normal})
        for (denoise::Plane& plane : *planes)
            plane.resize(size);
}

// Normal and depth of what is covered; the result has those of the whole pixel.
void fill(const reference::Result& traced, std::size_t i, denoise::NoisyPicture& picture)
{
    const reference::FirstSurfaces& firsts = *traced.first_surfaces;
    const float coverage = traced.radiance.values[4 * i + 3];
    const float per_cover = coverage > 0.0f ? 1.0f / coverage : 0.0f;
    for (std::size_t c = 0; c < 3; ++c) {
        picture.light[c][i] = traced.radiance.values[4 * i + c];
        picture.variance[c][i] = firsts.variance.values[3 * i + c];
        picture.emitted[c][i] = firsts.emitted.values[3 * i + c];
        picture.albedo[c][i] = firsts.albedo.values[3 * i + c];
        picture.normal[c][i] = per_cover * firsts.normal.values[3 * i + c];
    }
    picture.depth[i] = per_cover * firsts.depth[i];
    // Only samples that met something tell how much its light varies. A background without coverage is met by all.
    picture.coverage[i] = coverage > 0.0f ? std::min(coverage, 1.0f) : 1.0f;
    const auto met =
        static_cast<int>(std::lround(picture.coverage[i] * static_cast<float>(firsts.samples[i])));
    picture.freedom[i] = static_cast<float>(std::max(std::min(met, reference::replicates) - 1, 0));
}

} // namespace

image::RadianceImage denoised(const reference::Result& traced)
{
    denoise::NoisyPicture picture;
    picture.width = traced.radiance.width;
    picture.height = traced.radiance.height;
    const std::size_t size = traced.radiance.values.size() / 4;
    resize(picture, size);
    tbb::parallel_for(std::size_t{0}, size, [&](std::size_t i) { fill(traced, i, picture); });
    const denoise::Rgb light = denoise::filter_statistically(picture);
    image::RadianceImage result = traced.radiance;
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            result.values[4 * i + c] = light[c][i];
    return result;
}

} // namespace lambent::cli
