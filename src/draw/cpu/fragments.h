// The G-buffer of one tile, as columns: one fragment per surface seen in a pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent::draw {

/// What is known of a fragment. Every column is a float per fragment; names ending in r, g, b or x, y, z are vectors.
enum Column : std::size_t {
    // from visibility
    place_x,
    place_y, ///< in the picture, pixels
    hit_distance,
    hit_u,
    hit_v,
    extent, ///< Look::extent
    // the surface
    position_x,
    position_y,
    position_z,
    depth,
    view_x,
    view_y,
    view_z,
    shading_x,
    shading_y,
    shading_z, ///< shading normal, facing the viewer
    mirrored_dx_x,
    mirrored_dx_y,
    mirrored_dx_z,
    mirrored_dy_x,
    mirrored_dy_y,
    mirrored_dy_z,
    base_r,
    base_g,
    base_b, ///< ggx: base colour; phong: Kd
    specular_r,
    specular_g,
    specular_b, ///< phong: Ks
    gloss,      ///< ggx: alpha = perceptual roughness^2; phong: exponent
    metalness,
    occlusion,
    opacity,
    // light
    emitted_r,
    emitted_g,
    emitted_b,
    direct_r,
    direct_g,
    direct_b,
    irradiance_r,
    irradiance_g,
    irradiance_b,
    ambient_r,
    ambient_g,
    ambient_b,
    reflected_r,
    reflected_g,
    reflected_b,
    middle_level, ///< where layers are asked for: of the mips read in the lobe's middle, as a part of the highest
    column_count
};

/// Fragments in groups of one instance each; a group starts at a multiple of `group_alignment` and its last vector is
/// filled up with fragments of weight 0, so that SIMD loops need no tail.
class Fragments {
public:
    static constexpr std::size_t group_alignment = 16;

    struct Group {
        std::uint32_t instance = 0;
        std::size_t begin = 0, end = 0; ///< multiples of group_alignment
    };

    /// Room for `count` fragments; what the columns hold is then undefined.
    void resize(std::size_t count)
    {
        if (count > capacity_) {
            capacity_ = count + count / 2;
            values_.resize(capacity_ * column_count);
            pixel.resize(capacity_);
            weight.resize(capacity_);
            triangle.resize(capacity_);
        }
        size_ = count;
    }
    std::size_t size() const { return size_; }

    float* operator[](Column column) { return values_.data() + column * capacity_; }
    const float* operator[](Column column) const { return values_.data() + column * capacity_; }

    std::vector<std::uint32_t> pixel;    ///< index in the tile
    std::vector<float> weight;           ///< share of the pixel, 0 to 1
    std::vector<std::uint32_t> triangle; ///< of the group's mesh
    std::vector<Group> groups;

private:
    std::size_t size_ = 0, capacity_ = 0;
    std::vector<float> values_;
};

} // namespace lambent::draw
