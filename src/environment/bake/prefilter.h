// A panorama's light averaged over a lobe, in many directions at once.
#pragma once

#include "environment/bake/light_tree.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lambent::environment {

/// The weight w by which light is averaged, a function of the cosine of the angle to the lobe's axis; 0 below the
/// horizon. GGX, seen from R = N = V: w = cosine / q^2, q = alpha^2 + (1 - alpha^2) (1 - cosine) / 2.
struct PrefilterLobe {
    bool phong = false;    ///< w = cosine^exponent; else GGX
    double exponent = 1.0; ///< Phong's
    double alpha = 1.0;    ///< GGX's, or the roughness of a Phong lobe of the same width

    /// The integral of w over the hemisphere.
    double integral() const;
    /// w in double, by its definition.
    double weight(double cosine) const;
};

PrefilterLobe ggx_lobe(double alpha);
PrefilterLobe phong_lobe(double exponent);

/// Neighbouring texels, and the light that arrives at them. They are ordered as in a quadtree: the texels of a tile are
/// close together, and so are four consecutive tiles, and four such groups.
struct PrefilterPatch {
    static constexpr std::size_t tile = 16, most = 64 * tile;

    /// Sums over some of the cells, for each texel.
    struct Sums {
        alignas(64) float r[most], g[most], b[most]; ///< light times weight
        alignas(64) float weight[most];              ///< solid angle times weight
    };

    alignas(64) float x[most], y[most], z[most]; ///< unit length; a tile that is not full repeats a direction
    Sums dim, bright;                            ///< after fill(), `dim` holds the mean light
    std::size_t tiles = 0;
};

/// The extent, in radians, of the finest cells that a tree needs for that lobe.
double finest_extent(const PrefilterLobe& lobe, double fineness);

/// The mean over one lobe of the light in a tree. `fineness` is the ratio of a cell's distance, or of about half the
/// lobe's width, to the cell's extent: 0.7 gives errors of some tenths of a percent, which fall with its fourth power.
class Prefilter {
public:
    Prefilter(const LightTree& tree, const PrefilterLobe& lobe, double fineness);

    /// Buffers that a thread reuses from patch to patch.
    struct Scratch {
        struct CellIndex {
            int depth, column, row;
        };
        std::vector<CellIndex> left[6];     // cells left to the parts of the patch, by depth of the part
        std::vector<LightCell> dim, bright; // cells found
    };

    /// Fills a patch's `dim`.
    void fill(PrefilterPatch& patch, Scratch& scratch) const;

    /// For a row of cells: the least chord from which they are fine enough, below 0 for any, and the largest distance
    /// of their light from their centre.
    struct Bounds {
        float far, far_bright, reach;
        bool fine_at_horizon;
    };

    // The parameters of fill(), for an implementation on another device.
    const LightTree& tree() const { return tree_; }
    const PrefilterLobe& lobe() const { return lobe_; }
    const std::vector<std::vector<Bounds>>& bounds() const { return bounds_; } ///< [depth][row]
    float much_light() const { return much_light_; }           ///< cells of more light need far_bright
    float bright_radiance() const { return bright_radiance_; } ///< cells of more are summed separately

private:
    struct Part {
        std::size_t first, tiles, depth;
    };
    struct Cap;
    class Walk;

    void fill(PrefilterPatch& patch, const Part& part, Scratch& scratch) const;

    const LightTree& tree_;
    PrefilterLobe lobe_;
    float much_light_ = 0.0f;
    float bright_radiance_ = 0.0f;
    std::vector<std::vector<Bounds>> bounds_; // [depth][row]
};

/// Adds to `count` texels of a patch, from `first` on, the sum over cells of light times weight, with the weight's
/// curvature over each cell. (The SIMD part.)
struct PrefilterTexels {
    const PrefilterPatch& patch;
    PrefilterPatch::Sums& sums;
    std::size_t first, count; ///< multiples of PrefilterPatch::tile
};
void add_cells(std::span<const LightCell> cells, const PrefilterLobe& lobe, const PrefilterTexels& texels);

/// Sets `dim` to the mean light of each texel, from its sums and the lobe's integral. (The SIMD part.)
void finish_texels(PrefilterPatch& patch, double integral);

} // namespace lambent::environment
