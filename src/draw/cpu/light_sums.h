// Light of the pixels of a picture in its classes: what is known without noise, and what rays found.
#pragma once

#include "denoise/light_filter.h"
#include "draw/light/light_class.h"
#include "view/covered_area.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace lambent::draw {

/// Adds RGB to a pixel of three planes.
inline void add_to(denoise::Rgb& planes, std::size_t pixel, const glm::vec3& rgb)
{
    for (std::size_t c = 0; c < 3; ++c)
        planes[c][pixel] += rgb[static_cast<int>(c)];
}

inline glm::vec3 at(const denoise::Rgb& planes, std::size_t pixel)
{
    return {planes[0][pixel], planes[1][pixel], planes[2][pixel]};
}

/// What is known of the surfaces that pixels show, and what the rays that leave them found.
struct LightSums {
    view::PixelArea area;     ///< that the planes cover: no other pixel shows a surface
    denoise::Picture picture; ///< guides, exact light and albedo: sums, until make_means(); halves: means
    denoise::Rgb lights; ///< light of sources without size, without shadows and noise, of the whole pixel
    denoise::Rgb lights_unshadowed,
        lights_found;                   ///< sums of what the samples found of it, and of it with shadows
    std::array<denoise::Plane, 2> seen; ///< camera rays of each half that met a surface

    /// Sums of zero; those of lights are empty planes without `lights`.
    LightSums(const view::PixelArea& area, bool has_lights);

    bool has_lights() const { return !lights[0].empty(); }

    /// Whether the planes have a pixel of the picture, and its index in them.
    bool has(int x, int y) const
    {
        return x >= area.x && y >= area.y && x < area.x + area.width && y < area.y + area.height;
    }
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y - area.y) * static_cast<std::size_t>(area.width) +
               static_cast<std::size_t>(x - area.x);
    }

    denoise::Light& light(std::size_t light_class)
    {
        return light_class == diffuse_light ? picture.diffuse : picture.specular;
    }

    /// Adds what the rays of a sample found to the means of one half. These are means at all times, so that the filter
    /// can be asked for a picture after any pass.
    void add(std::size_t pixel, std::size_t half, const RayLight& found);
};

/// Turns the sums over the surfaces of a pixel into means over its covered part, as the filter takes them.
void make_means(LightSums& sums);

} // namespace lambent::draw
