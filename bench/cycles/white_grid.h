// What both programs render: 7x7 spheres of white metal, roughness growing to the right.
#pragma once

#include "scene/scene.h"
#include "view/camera.h"

#include <string>
#include <vector>

namespace lambent::bench {

struct PictureSize {
    int width, height;
};

/// The built-in `grid` in finer triangles, each sphere a perfect white reflector: no Fresnel, no colour.
scene::Scene make_white_grid();

/// Where `lambent render grid` stands.
view::Camera grid_camera(const scene::Scene& grid, PictureSize size);

/// Spheres of one roughness, and for each the pixels that see only it, as y * width + x.
struct Column {
    double perceptual_roughness;
    std::vector<std::vector<std::size_t>> spheres;
};

/// Pixels whose middles look past a sphere's centre by at most nine tenths of its radius.
std::vector<Column> inner_pixels(const scene::Scene& grid, PictureSize size);

} // namespace lambent::bench
