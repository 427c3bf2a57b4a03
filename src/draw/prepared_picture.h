// Values that every backend derives from a picture's settings before drawing.
#pragma once

#include "draw/frame.h"
#include "draw/light_context.h"

#include <glm/vec2.hpp>

#include <span>
#include <vector>

namespace lambent::draw {

/// Supersampling of edges: the visibility samples (looks) of a pixel, and which of them share a shading point.
struct Edges {
    std::vector<glm::vec2> places; ///< positions of the looks in a pixel, [0, 1)
    float bend_cosine = 0.0f;      ///< normals of neighbouring pixels with a smaller cosine are an edge
    float shared_cosine = 0.0f;    ///< looks with a larger cosine between normals share a shading point
    float extent = 1.0f;           ///< side of the square that a look covers, pixels
};

/// Has members that point to other members, so it cannot be copied or moved.
struct PreparedPicture {
    /// `environment` (may be null) and `given` must outlive this.
    PreparedPicture(std::span<const scene::Light> scene_lights, const environment::Environment* environment,
                    const Settings& given);
    PreparedPicture(const PreparedPicture&) = delete;
    PreparedPicture& operator=(const PreparedPicture&) = delete;

    const Settings& settings;
    RayMap rays;
    Edges edges;
    SampleTables tables;
    std::vector<environment::Panorama> mips; ///< for Model::phong with MipLevel::report; else empty
    LightContext light;
    std::vector<LightSource> lights;
    float background_level = -1.0f; ///< of blur; negative: the panorama itself
};

/// The lights of both lists in the form that the passes read.
std::vector<LightSource> light_sources(std::span<const scene::Light> lights,
                                       std::span<const scene::Light> more);

/// An empty frame of the settings' size: with an image for unlit surfaces if the scene has unlit materials, and with
/// layers if the settings ask for them.
Frame blank_frame(const Settings& settings, const scene::Scene& scene);

/// A ray ends behind transparent surfaces when its remaining weight is below `least_weight`, or after `most_waves`
/// layers of surfaces.
constexpr float least_weight = 1.0f / 1024.0f;
constexpr int most_waves = 256;

} // namespace lambent::draw
