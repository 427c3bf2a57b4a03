#include "draw/cpu/light_sums.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace lambent::draw {
namespace {

void clear(denoise::Rgb& planes, std::size_t pixels)
{
    for (denoise::Plane& plane : planes)
        plane.assign(pixels, 0.0f);
}

void scale(denoise::Rgb& planes, std::size_t pixel, float factor)
{
    for (denoise::Plane& plane : planes)
        plane[pixel] *= factor;
}

float inverse(float value)
{
    return value > 0.0f ? 1.0f / value : 0.0f;
}

void make_mean(LightSums& sums, std::size_t pixel)
{
    denoise::Guides& guides = sums.picture.guides;
    const float covered = inverse(guides.coverage[pixel]);
    for (denoise::Plane* const plane : {&guides.depth, &guides.alpha, &guides.metalness})
        (*plane)[pixel] *= covered;
    const glm::vec3 normal = at(guides.normal, pixel);
    const float length = std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
    scale(guides.normal, pixel, inverse(length));
    guides.depth[pixel] = std::max(guides.depth[pixel], 1e-30f);
    scale(sums.picture.diffuse.albedo, pixel, covered);
    for (std::size_t k = 0; k < light_classes; ++k)
        scale(sums.light(k).exact, pixel, covered);
}

} // namespace

LightSums::LightSums(const view::PixelArea& pixel_area, bool with_lights) : area(pixel_area)
{
    picture.width = area.width;
    picture.height = area.height;
    const std::size_t pixels = static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height);
    denoise::Guides& guides = picture.guides;
    for (denoise::Plane* const plane :
         {&guides.coverage, &guides.depth, &guides.alpha, &guides.metalness, &seen[0], &seen[1]})
        plane->assign(pixels, 0.0f);
    picture.count.assign(pixels, 2.0f);
    clear(guides.normal, pixels);
    clear(picture.diffuse.albedo, pixels);
    for (denoise::Rgb* const planes : {&lights, &lights_unshadowed, &lights_found})
        clear(*planes, with_lights ? pixels : 0);
    for (std::size_t k = 0; k < light_classes; ++k) {
        clear(light(k).exact, pixels);
        for (denoise::Half& half : light(k).halves)
            clear(half.unshadowed, pixels), clear(half.found, pixels);
    }
}

void LightSums::add(std::size_t pixel, std::size_t half, const RayLight& found)
{
    float& count = seen[half][pixel];
    count += 1.0f;
    picture.count[pixel] = std::max(seen[0][pixel] + seen[1][pixel], 2.0f);
    const float share = 1.0f / count;
    for (std::size_t k = 0; k < light_classes; ++k) {
        denoise::Half& mean = light(k).halves[half];
        add_to(mean.unshadowed, pixel, share * (found.unshadowed[k] - at(mean.unshadowed, pixel)));
        add_to(mean.found, pixel, share * (found.found[k] - at(mean.found, pixel)));
    }
}

void make_means(LightSums& sums)
{
    tbb::parallel_for(std::size_t{0}, sums.seen[0].size(), [&](std::size_t pixel) {
        if (sums.picture.guides.coverage[pixel] > 0.0f)
            make_mean(sums, pixel);
    });
}

} // namespace lambent::draw
