// Rays that are traced together, and the surfaces that they meet as fragments.
#pragma once

#include "draw/cpu/fragments.h"
#include "draw/cpu/tile.h"
#include "trace/visibility.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace lambent::draw {

/// A ray, and the surface that stops it.
struct WaveRay {
    glm::vec3 origin{0.0f}, direction{0.0f};                         ///< of unit length
    float near = 0.0f, far = std::numeric_limits<float>::infinity(); ///< metres
    float spread = 0.0f;        ///< change of the direction to a neighbouring ray, radians
    std::uint32_t owner = 0;    ///< what the ray is for, as the caller counts
    std::uint32_t seed = 0;     ///< of its passage through surfaces that are not opaque
    std::uint32_t sequence = 0; ///< of random_number, for the rays that leave what it meets
    std::uint32_t sample = 0;   ///< its index there
    bool skips_backs =
        false; ///< whether it passes through the backs of one-sided surfaces, as camera rays do
    Hit hit;
};

/// Traces rays, and finds the surfaces that they meet; reuses its buffers from call to call.
class RayWave {
public:
    explicit RayWave(const PictureContext& picture)
        : picture_(picture), group_at_(picture.scene.instance_count(), no_group)
    {
    }

    /// Fills the hits of all rays. Surfaces that are not opaque stop a ray with the probability of their opacity.
    /// `parallel`: whether neighbouring rays are nearly parallel.
    void cast(std::vector<WaveRay>& rays, bool parallel);

    /// Whether each ray meets a surface before its end, as cast() decides it: 1 or 0.
    void block(std::vector<WaveRay>& rays, std::vector<std::uint8_t>& blocked);

    /// Makes a fragment of each ray that met a surface, and finds the surfaces. Fragment::pixel is the index of the ray.
    /// `extent` as in Look.
    void find(std::span<const WaveRay> rays, float extent);

    Fragments& fragments() { return fragments_; }
    const Fragments& fragments() const { return fragments_; }

    /// The rays of the last find(), which must still exist.
    std::span<const WaveRay> rays() const { return rays_; }

private:
    static constexpr std::uint32_t no_group = ~0u;

    void trace(const std::vector<WaveRay*>& rays, bool parallel);
    std::size_t pass(std::vector<WaveRay*>& rays);
    void make_groups(std::span<const WaveRay> rays, Fragments& fragments);
    void place(std::span<const WaveRay> rays, float extent, Fragments& fragments);
    void find_groups(Fragments& fragments);

    const PictureContext& picture_;
    Fragments fragments_{all_ray_columns};
    Fragments veils_{all_ray_columns}; ///< surfaces that are not opaque
    std::span<const WaveRay> rays_;
    std::vector<WaveRay*> waiting_;
    std::vector<WaveRay> veiled_;
    std::vector<std::uint32_t> group_at_; ///< by instance: its group, while groups are made
    Rays packet_;
    std::vector<Hit> hits_;
};

} // namespace lambent::draw
