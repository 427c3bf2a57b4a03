// Values that every backend derives from a picture's settings before drawing.
#pragma once

#include "draw/frame.h"
#include "draw/light_context.h"

#include <glm/vec2.hpp>

#include <array>
#include <span>
#include <vector>

namespace lambent::draw {

/// Supersampling of edges: the visibility samples (looks) of a pixel, and which of them share a shading point. A pixel
/// at an edge whose four corners share that of its centre is shaded there, as pixels inside surfaces are.
struct Edges {
    std::vector<glm::vec2> places; ///< positions of the looks in a pixel, [0, 1)
    std::array<int, 4> corners{};  ///< of `places`: the nearest to each corner of the pixel
    float bend_cosine = 0.0f;      ///< normals of neighbouring pixels with a smaller cosine are an edge
    float shared_cosine =
        0.0f;            ///< the least cosine between normals of looks that share a shading point; smooth
                         ///< surfaces have a larger one, see shared_cosine() in shading/surface/pixel.glsl
    float extent = 1.0f; ///< side of the square that a look covers, pixels
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
    SampleTables
        few_tables; ///< for fragments that cover less than small_share of a pixel: their error counts less
    SampleTables hit_tables; ///< for surfaces that light comes from, not those that the camera sees
    std::vector<environment::Panorama> mips; ///< for Model::phong with MipLevel::report; else empty
    LightContext light;                      ///< with `tables`
    LightContext few_light;                  ///< the same with `few_tables`
    LightContext hit_light;                  ///< the same with `hit_tables`
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
