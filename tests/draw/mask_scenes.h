// Squares with masks whose shares that are there are known.
#pragma once

#include "tests/draw/test_scenes.h"

#include <cmath>
#include <functional>
#include <vector>

namespace lambent::draw::testing {

/// RGBA, white where alpha is above 0, else black. alpha(x, y) in codes.
inline image::CodeImage mask_image(int size, const std::function<int(int x, int y)>& alpha)
{
    image::CodeImage codes{size, size, 4, 8, {}};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const auto a = static_cast<std::uint8_t>(alpha(x, y));
            const std::uint8_t color = a > 0 ? 255 : 0;
            codes.bytes.insert(codes.bytes.end(), {color, color, color, a});
        }
    return codes;
}

/// Opaque squares of 4 texels, a quarter of the area.
inline image::CodeImage squares_of_four()
{
    return mask_image(256, [](int x, int y) { return x % 8 < 4 && y % 8 < 4 ? 255 : 0; });
}

/// The share of that which is at or above a cutoff, bilinear: nine cells between the opaque texels, four times three between
/// an opaque and a clear one, four corners where alpha is x y.
inline double share_of_squares(double cutoff)
{
    const double side = 1.0 - cutoff, corner = 1.0 - cutoff + cutoff * std::log(cutoff);
    return (9.0 + 12.0 * side + 4.0 * corner) / 64.0;
}

/// Fence posts: columns of one texel in sixteen; and their share.
inline image::CodeImage thin_posts()
{
    return mask_image(256, [](int x, int) { return x % 16 == 5 ? 255 : 0; });
}
inline double share_of_posts(double cutoff)
{
    return 2.0 * (1.0 - cutoff) / 16.0;
}

inline scene::Material mask_material(float cutoff)
{
    scene::Material material;
    material.unlit = true;
    material.alpha_mode = scene::AlphaMode::mask;
    material.alpha_cutoff = cutoff;
    material.base_color_texture.image = 0;
    return material;
}

/// A square that fills the picture of mask_view().
inline scene::Scene mask_scene(const image::CodeImage& codes, const scene::Material& material)
{
    scene::Scene scene;
    add(scene, facing_square(1.0f, 0.0f), material);
    scene.images.push_back(codes);
    return scene;
}

inline Settings mask_view(int size)
{
    return small_settings(size, size, front_camera(2.0f));
}

inline double mean_of(const Frame& frame, int channel)
{
    double sum = 0.0;
    for (int y = 0; y < frame.radiance.height; ++y)
        for (int x = 0; x < frame.radiance.width; ++x)
            sum += static_cast<double>(frame.radiance.pixel(x, y)[channel]);
    return sum / (frame.radiance.width * frame.radiance.height);
}

/// From larger than the texture to smaller than its pattern; none of them in step with it.
constexpr int mask_sizes[] = {509, 301, 201, 127, 75, 41, 32, 16, 8};

} // namespace lambent::draw::testing
