// What a picture shows and how it is to be understood: everything that any way of making it has to agree on.
#pragma once

#include "scene/scene.h"
#include "view/camera.h"

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace lambent::view {

/// Which material model lights the surfaces: the report's, or glTF's metallic-roughness with GGX.
enum class Model { ggx, phong };

/// What texel codes mean: exact sRGB, the report's power of 2.2, or the codes themselves (the report's comparison).
enum class TexelTransfer { srgb, power_2_2, none };

/// What is seen where there is no surface.
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
    /// Perceptual, 0 to 1, of every surface, whatever its material and texture say. Exponents that materials have are kept.
    std::optional<float> roughness_override;
    bool energy_compensation = true;   ///< give back what single scattering loses on rough surfaces (ggx)
    float environment_rotation = 0.0f; ///< radians about +Y, counter-clockwise seen from above
    Background background;
    std::vector<scene::Light> lights; ///< besides the scene's own
};

} // namespace lambent::view
