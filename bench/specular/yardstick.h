// The yardstick: a kernel written for one thing alone, the report's 40-sample specular pass on a scene of one sphere and
// a floor, over Highway lanes with gathers of packed texels. What it takes is what this machine can do without any of
// the product's generality.
#pragma once

#include <cstdint>
#include <vector>

namespace lambent::bench {

constexpr int yardstick_width = 1280, yardstick_height = 720, yardstick_samples = 40;

/// A cube map of RGB9E5 texels with mip maps; the level of face size n starts at texel 24 n^2, each face with a border.
struct YardstickCube {
    std::vector<std::int32_t> texels;
    int log2_size = 0;
};

struct YardstickScene {
    float eye[3], forward[3], right[3], up[3]; ///< right and up reach to the edges of the picture
    float points[yardstick_samples][3];        ///< cos phi, sin phi, log2 xi2
    YardstickCube environment, irradiance;
    float base_level;
};

/// Light from a direction: a sky with a sun and two lamps over patterned ground.
void yardstick_radiance(const float direction[3], float rgb[3]);

/// The scene with its cube maps. Takes a second.
YardstickScene make_yardstick_scene();

/// Row y of the picture, RGBA, with the best instructions of the processor.
void draw_yardstick_row(const YardstickScene& scene, int y, float* rgba);

/// Normal, direction to the viewer, exponent and Ks of every shaded pixel of the same picture.
struct YardstickSurface {
    float normal[3], view[3], exponent, specular[3];
};
std::vector<YardstickSurface> yardstick_surfaces(const YardstickScene& scene);

} // namespace lambent::bench
