// What every backend works out of a picture's settings before it draws.
#pragma once

#include "draw/frame.h"
#include "draw/light_context.h"

#include <glm/vec2.hpp>

#include <span>
#include <vector>

namespace lambent::draw {

/// Where a pixel is looked at several times, and which of these looks are lit as one.
struct Edges {
    std::vector<glm::vec2> places; ///< inside a pixel, [0, 1)
    float bend_cosine = 0.0f;      ///< a surface that bends further from pixel to pixel is an edge
    float shared_cosine = 0.0f; ///< looks share one shading point while the surface bends less between them
    float extent = 1.0f;        ///< of a look
};

/// Refers to itself: stays where it was made.
struct PreparedPicture {
    /// The environment (may be null) and the settings must outlive it.
    PreparedPicture(std::span<const scene::Light> scene_lights, const environment::Environment* environment,
                    const Settings& given);
    PreparedPicture(const PreparedPicture&) = delete;
    PreparedPicture& operator=(const PreparedPicture&) = delete;

    const Settings& settings;
    RayMap rays;
    Edges edges;
    SampleTables tables;
    std::vector<environment::Panorama> mips; ///< the report's, where its levels are asked for
    LightContext light;
    std::vector<LightSource> lights;
    float background_level = -1.0f; ///< of blur; below 0: the panorama itself
};

/// The scene's lights and `more`, as the passes want them.
std::vector<LightSource> light_sources(std::span<const scene::Light> lights,
                                       std::span<const scene::Light> more);

/// A picture of the settings' size with nothing in it, with room for what materials without lighting show if there are some,
/// and its layers where they are asked for.
Frame blank_frame(const Settings& settings, const scene::Scene& scene);

/// What is left of a ray behind transparent surfaces is not worth following below this, nor further than this many.
constexpr float least_weight = 1.0f / 1024.0f;
constexpr int most_waves = 256;

} // namespace lambent::draw
