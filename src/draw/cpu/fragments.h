// The G-buffer of one tile, stored by columns: one fragment per surface seen in a pixel.
#pragma once

#include "draw/columns.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent::draw {

/// Columns after those of draw/columns.h, filled from visibility.
enum VisibilityColumn : int {
    place_x = column_count,
    place_y, ///< position in the picture, pixels
    hit_distance,
    hit_u,
    hit_v,
    extent, ///< Look::extent
    all_columns
};

/// Further columns of fragments that rays meet and leave (ray_wave.h, ray_kernel.h). A vector takes three.
enum RayColumn : int {
    met_from = all_columns,     ///< origin of the ray that met the fragment
    met_along = met_from + 3,   ///< its direction, unit length
    met_spread = met_along + 3, ///< change of its direction to the next pixel, radians

    // Random numbers in [0, 1) by which rays are chosen.
    random_lobe,
    random_xi2,
    random_xi1,
    random_lamp,
    random_lamp_xi2,
    random_lamp_xi1,
    random_light,

    // The ray along a lobe: LobeRay of shading/passes/rays.glsl.
    lobe_way,
    lobe_diffuse = lobe_way + 3,
    lobe_glossy = lobe_diffuse + 3,
    lobe_radiance = lobe_glossy + 3,
    lobe_density = lobe_radiance + 3,

    // The ray to a lamp of the environment, and the ray to a light of the scene: LampRay.
    lamp_way,
    lamp_diffuse = lamp_way + 3,
    lamp_glossy = lamp_diffuse + 3,
    light_way = lamp_glossy + 3,
    light_diffuse = light_way + 3,
    light_glossy = light_diffuse + 3,
    light_distance =
        light_glossy + 3, ///< to the light, metres; 1e30 for directional lights, 0 without a light

    all_ray_columns
};

/// Fragments in groups of one instance, and of small or large fragments, each. A group starts at a multiple of
/// `group_alignment` and is padded to the next with fragments of weight 0, so that SIMD loops need no tail.
class Fragments {
public:
    static constexpr std::size_t group_alignment = 16;

    /// Fragments with that many columns: all_columns or all_ray_columns.
    explicit Fragments(int columns = all_columns) : columns_(static_cast<std::size_t>(columns)) {}

    struct Group {
        std::uint32_t instance = 0;
        bool small = false;             ///< whether its fragments cover less than `small_share` of a pixel
        std::size_t begin = 0, end = 0; ///< multiples of group_alignment
    };

    /// Resizes to `count` fragments, whose columns are then undefined.
    void resize(std::size_t count)
    {
        if (count > capacity_) {
            capacity_ = count + count / 2;
            values_.resize(capacity_ * columns_);
            pixel.resize(capacity_);
            weight.resize(capacity_);
            triangle.resize(capacity_);
        }
        size_ = count;
    }
    std::size_t size() const { return size_; }

    float* operator[](int column) { return values_.data() + static_cast<std::size_t>(column) * capacity_; }
    const float* operator[](int column) const
    {
        return values_.data() + static_cast<std::size_t>(column) * capacity_;
    }
    std::size_t capacity() const { return capacity_; } ///< distance between columns, floats

    std::vector<std::uint32_t> pixel;    ///< index in the tile
    std::vector<float> weight;           ///< share of the pixel, 0 to 1
    std::vector<std::uint32_t> triangle; ///< index in the group's mesh
    std::vector<Group> groups;

private:
    std::size_t columns_, size_ = 0, capacity_ = 0;
    std::vector<float> values_;
};

} // namespace lambent::draw
