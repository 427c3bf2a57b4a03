// A panorama's light averaged over a lobe, in many directions at once.
#pragma once

#include "environment/bake/light_tree.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lambent::environment {

/// What light is averaged with: w(cosine) for the angle to the lobe's middle, 0 below the horizon.
struct PrefilterLobe {
    bool phong = false;    ///< w = cosine^exponent; else GGX seen from R = N = V: w = cosine / q^2,
    double exponent = 1.0; ///< q = alpha^2 + (1 - alpha^2) (1 - cosine) / 2
    double alpha = 1.0;    ///< GGX's, or the roughness that is as wide

    /// The integral of w over the hemisphere.
    double integral() const;
    /// w in double, by its definition.
    double weight(double cosine) const;
};

PrefilterLobe ggx_lobe(double alpha);
PrefilterLobe phong_lobe(double exponent);

/// Texels near each other, and what arrives there. By tiles of directions nearer still; four tiles one after the other
/// are near, too, and so are four such fours.
struct PrefilterPatch {
    static constexpr std::size_t tile = 16, most = 64 * tile;

    /// Of some cells, by texel.
    struct Sums {
        alignas(64) float r[most], g[most], b[most]; ///< light times weight
        alignas(64) float weight[most];              ///< solid angle times weight
    };

    alignas(64) float x[most], y[most], z[most]; ///< unit length; a tile that is not full repeats a direction
    Sums dim, bright;                            ///< after fill(), light is in `dim`
    std::size_t tiles = 0;
};

/// Of a tree for that lobe.
double finest_extent(const PrefilterLobe& lobe, double fineness);

/// The mean over one lobe of the light in a tree. `fineness` is how many times a cell is smaller than its distance or
/// about half the lobe: 0.7 gives errors of some tenths of a percent, which fall with its fourth power.
class Prefilter {
public:
    Prefilter(const LightTree& tree, const PrefilterLobe& lobe, double fineness);

    /// What a thread keeps from patch to patch for its memory.
    struct Scratch {
        struct CellIndex {
            int depth, column, row;
        };
        std::vector<CellIndex> left[6];     // by depth of the part of the patch
        std::vector<LightCell> dim, bright; // cells
    };

    /// Fills a patch's `dim`.
    void fill(PrefilterPatch& patch, Scratch& scratch) const;

    /// A row of cells: the least chord from which they are fine enough, less than 0 for any, and how far their light
    /// may be from their middle.
    struct Bounds {
        float far, far_bright, reach;
        bool fine_at_horizon;
    };

    // What fill() goes by, for who does the same elsewhere.
    const LightTree& tree() const { return tree_; }
    const PrefilterLobe& lobe() const { return lobe_; }
    const std::vector<std::vector<Bounds>>& bounds() const { return bounds_; } ///< [depth][row]
    float much_light() const { return much_light_; }           ///< of a cell that asks for far_bright
    float bright_radiance() const { return bright_radiance_; } ///< of a cell that is summed apart

private:
    struct Part {
        std::size_t first, tiles, depth;
    };
    struct Cap;
    class Walk;

    void fill(PrefilterPatch& patch, const Part& part, Scratch& scratch) const;

    const LightTree& tree_;
    PrefilterLobe lobe_;
    float much_light_ = 0.0f;                 // of a cell that asks for more
    float bright_radiance_ = 0.0f;            // of a cell that is summed apart
    std::vector<std::vector<Bounds>> bounds_; // [depth][row]
};

/// Adds to texels of a patch, from the first on, the sum over cells of light times weight, with the weight's curvature
/// over each cell. (The SIMD part.)
struct PrefilterTexels {
    const PrefilterPatch& patch;
    PrefilterPatch::Sums& sums;
    std::size_t first, count; ///< multiples of PrefilterPatch::tile
};
void add_cells(std::span<const LightCell> cells, const PrefilterLobe& lobe, const PrefilterTexels& texels);

/// Of all texels of a patch the mean from its sums and the lobe's integral, into `dim`. (The SIMD part.)
void finish_texels(PrefilterPatch& patch, double integral);

} // namespace lambent::environment
