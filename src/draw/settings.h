// What to draw and how: everything a picture depends on but the scene and the environment.
#pragma once

#include "draw/camera.h"
#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace lambent::draw {

/// Which material model lights the surfaces: the report's, or glTF's metallic-roughness with GGX.
enum class Model { ggx, phong };

/// How the phong model samples the environment: points in a spiral, each read at a blur that matches its share of the
/// lobe; or the report's Hammersley points and formula of the level in the panorama's own mip chain, which shows blocks.
enum class MipLevel { matched, report };

/// What texel codes mean: exact sRGB, the report's power of 2.2, or the codes themselves (the report's comparison).
enum class TexelTransfer { srgb, power_2_2, none };

/// What is seen where there is no surface.
struct Background {
    enum class Kind { environment, none, color, blurred };
    Kind kind = Kind::environment;
    glm::vec3 color{0.0f};  ///< radiance, for Kind::color
    float roughness = 0.0f; ///< perceptual, 0 to 1, for Kind::blurred
};

struct Settings {
    int width = 1280; ///< 1 to 65536
    int height = 720; ///< 1 to 65536
    Camera camera;
    Model model = Model::ggx;
    int samples = 40; ///< of the specular lobe, 1 to 65536
    MipLevel mip_level = MipLevel::matched;
    TexelTransfer texel_transfer = TexelTransfer::srgb;
    bool energy_compensation = true;   ///< give back what single scattering loses on rough surfaces (ggx)
    float ambient_brightness = 1.0f;   ///< factor on the diffuse light of the environment; the report's is 2
    float environment_rotation = 0.0f; ///< radians about +Y, counter-clockwise seen from above
    int edge_samples = 4;              ///< per pixel where surfaces end or bend, 1 to 64
    Background background;
    std::vector<scene::Light> lights; ///< besides the scene's own
    bool layers = false;              ///< also return the G-buffer and the light of each pass
};

} // namespace lambent::draw
