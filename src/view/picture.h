// The description of a picture to draw, which all renderers and the path tracer share.
#pragma once

#include "scene/scene.h"
#include "view/camera.h"

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace lambent::view {

/// The material model that shades surfaces: the report's Phong model, or glTF's metallic-roughness model with GGX.
enum class Model { ggx, phong };

/// The decoding of colour textures: exact sRGB, the report's power of 2.2, or none (for the report's comparison).
enum class TexelTransfer { srgb, power_2_2, none };

/// What pixels without a surface show.
struct Background {
    enum class Kind { environment, none, color, blurred };
    Kind kind = Kind::environment;
    glm::vec3 color{0.0f};  ///< radiance, for Kind::color
    float roughness = 0.0f; ///< perceptual, 0 to 1, for Kind::blurred
};

struct Picture {
    int width = 1280; ///< 1 to 65536
    int height = 720; ///< 1 to 65536
    Camera camera;
    Model model = Model::ggx;
    TexelTransfer texel_transfer = TexelTransfer::srgb;
    /// Perceptual roughness, 0 to 1, of every surface in place of its material's and texture's. Phong exponents that
    /// materials set are kept.
    std::optional<float> roughness_override;
    /// Whether to add the energy that single scattering loses on rough surfaces (ggx).
    bool energy_compensation = true;
    float environment_rotation = 0.0f; ///< radians about +Y, counter-clockwise seen from above
    Background background;
    std::vector<scene::Light> lights; ///< besides the scene's own
};

} // namespace lambent::view
