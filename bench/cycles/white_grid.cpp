#include "bench/cycles/white_grid.h"

#include "scene/builtin/builtin.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <map>

namespace lambent::bench {
namespace {

// So that the rim's corners and the bent normals are far below a pixel: 152 x 80 quadrilaterals.
constexpr double density = 4.0;

constexpr float inner_share = 0.9f;

} // namespace

scene::Scene make_white_grid()
{
    scene::BuiltinOptions options;
    options.density = density;
    scene::Scene grid = scene::make_builtin("grid", options);
    for (scene::Material& material : grid.materials) {
        material.base_color = glm::vec4(1.0f);
        material.metallic = 1.0f;
    }
    return grid;
}

view::Camera grid_camera(const scene::Scene& grid, PictureSize size)
{
    constexpr float vertical_fov = 0.7853982f;
    return view::orbit_camera(scene::bounds(grid), {}, vertical_fov,
                              static_cast<float>(size.width) / static_cast<float>(size.height));
}

std::vector<Column> inner_pixels(const scene::Scene& grid, PictureSize size)
{
    const view::RayMap rays = view::ray_map(grid_camera(grid, size), size.width, size.height);
    const float radius = glm::length(grid.meshes[0].positions[0]);
    std::vector<std::vector<std::size_t>> seen(grid.instances.size());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const glm::vec3 towards =
                glm::normalize(rays.direction + (static_cast<float>(x) + 0.5f) * rays.direction_dx +
                               (static_cast<float>(y) + 0.5f) * rays.direction_dy);
            for (std::size_t i = 0; i < grid.instances.size(); ++i) {
                const glm::vec3 centre(grid.instances[i].transform[3]);
                if (glm::length(glm::cross(centre - rays.origin, towards)) <= inner_share * radius)
                    seen[i].push_back(static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                      static_cast<std::size_t>(x));
            }
        }
    std::map<float, Column> columns;
    for (std::size_t i = 0; i < grid.instances.size(); ++i) {
        const auto material = static_cast<std::size_t>(grid.instances[i].material);
        const float roughness = grid.materials[material].perceptual_roughness;
        Column& column = columns[roughness];
        column.perceptual_roughness = static_cast<double>(roughness);
        column.spheres.push_back(std::move(seen[i]));
    }
    std::vector<Column> result;
    result.reserve(columns.size());
    for (auto& [roughness, column] : columns)
        result.push_back(std::move(column));
    return result;
}

} // namespace lambent::bench
