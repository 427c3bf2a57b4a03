// A panorama's light averaged over a lobe, in many directions at once.
#pragma once

#include "environment/light_tree.h"

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

/// Directions near each other, and what arrives there.
struct PrefilterTile {
    static constexpr std::size_t most = 16;
    alignas(64) float x[most] = {}, y[most] = {}, z[most] = {}; ///< unit length
    alignas(64) float rgb[3][most] = {};
    std::size_t count = 0;
};

/// Cells that stand for all light that a tile sees; kept from tile to tile for its memory.
struct CellList {
    std::vector<float> x, y, z, r, g, b, variance;

    void clear();
    std::size_t size() const { return x.size(); }
};

/// Fills a tile's rgb with the mean over the lobe. `fineness` is how many times a cell is smaller than its distance or
/// the lobe, about 4; the error falls with its fourth power.
void prefilter_tile(const LightTree& tree, const PrefilterLobe& lobe, double fineness, CellList& cells,
                    PrefilterTile& tile);

/// The sum over cells of light times weight, with the weight's curvature over each cell. (The SIMD part.)
void add_cells(const CellList& cells, const PrefilterLobe& lobe, PrefilterTile& tile);

/// A direction in which the mean over a lobe is wanted of all texels, one by one, in double: to check the tree by.
struct TexelSum {
    double x = 0.0, y = 0.0, z = 0.0; ///< unit length
    PrefilterLobe lobe;
    double rgb[3] = {};
};
void sum_texels(const Panorama& panorama, std::span<TexelSum> sums);

/// A row of texels, for the loop of sum_texels: directions share their height. `count` is a multiple of 8, what is beyond
/// the row has no light.
struct TexelRow {
    const double *x, *z;     ///< on the unit circle
    const double *r, *g, *b; ///< radiance
    double y, ring;          ///< height, and radius at that height
    double area;             ///< solid angle of a texel
    std::size_t count;
};
void add_texel_row(const TexelRow& row, TexelSum& sum);

} // namespace lambent::environment
