// Built-in scenes.
#pragma once

#include "scene/scene.h"

#include <optional>
#include <span>
#include <string_view>

namespace lambent::scene {

struct BuiltinOptions {
    float density = 1.0f;              ///< triangles along an edge, relative to the default; 1/16 to 8
    std::optional<glm::vec3> diffuse;  ///< Kd of every material's PhongMaterial
    std::optional<glm::vec3> specular; ///< Ks, likewise
    std::optional<float> exponent;     ///< Phong exponent, likewise; 0 < exponent <= 1e6
};

/// The names that make_builtin knows:
///  - sphere: glossy red paint, radius 0.5 m, standing on y = 0;
///  - teapot: Newell's, white glaze, 0.3 m long, standing on y = 0;
///  - plane: 2 x 2 m at y = 0, facing up, seen from both sides;
///  - report: sphere, teapot and plane with one directional and two point lights;
///  - painted: a sphere of radius 0.5 m with a chart of colours, standing on a tiled plane;
///  - grid: 7 x 7 spheres of gold colour facing +Z, perceptual roughness 0 to 1 from left to right,
///    metallic 0 to 1 from bottom to top;
///  - furnace: 11 x 3 white spheres, roughness and metallic likewise.
std::span<const std::string_view> builtin_names();

bool is_builtin(std::string_view name);

/// Throws Error(usage) for an unknown name or an option outside its range.
Scene make_builtin(std::string_view name, const BuiltinOptions& options = {});

} // namespace lambent::scene
