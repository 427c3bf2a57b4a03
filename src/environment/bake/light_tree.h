// A panorama's light in cells, coarser from level to level: far from a direction, or for a wide lobe, one cell stands
// for many texels. [Barnes and Hut 1986, "A hierarchical O(N log N) force-calculation algorithm"]
#pragma once

#include "environment/panorama/panorama.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent::environment {

struct LightCell {
    float x, y, z;  ///< direction of the centroid of its light, unit length
    float variance; ///< of its light about that direction, angular, per axis, square radians
    float r, g, b;  ///< its light: radiance times solid angle
    float area;     ///< solid angle; 0 if its centroid is not that of the light: then another cell has it
};

/// Cells of one size, row by row as the panorama.
struct LightCellLevel {
    int width = 0, height = 0;
    std::vector<LightCell> cells; ///< none at a level whose cells are the panorama's texels
    std::vector<float> extent;    ///< [row]: the longer side of its cells, radians

    /// [row]: for each of its cells of area 0, in order, a cell with that area and no light.
    std::vector<std::vector<LightCell>> areas;
    std::vector<std::uint16_t> area_index; ///< [cell]: index into its row of `areas`

    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    }
};

/// Levels from the finest on; each has a quarter of the cells of the one before, the last at most 32 columns.
class LightTree {
public:
    /// `extent` is the size in radians that the finest cells need. They are the texels themselves if it is less than
    /// two texels, and have at most 2048 columns. The panorama must outlive the tree.
    LightTree(const Panorama& panorama, double extent);

    const std::vector<LightCellLevel>& levels() const { return levels_; }

    LightCell cell(std::size_t depth, int column, int row) const
    {
        const LightCellLevel& level = levels_[depth];
        return level.cells.empty() ? texel(column, row) : level.cells[level.index(column, row)];
    }

    /// The cell with the area of a cell whose own is 0.
    const LightCell& area(std::size_t depth, int column, int row) const
    {
        const LightCellLevel& level = levels_[depth];
        return level.areas[static_cast<std::size_t>(row)][level.area_index[level.index(column, row)]];
    }

private:
    struct Turn {
        float cosine, sine;
    };
    struct Row {
        float up, ring, area;
    };

    LightCell texel(int column, int row) const
    {
        const Rgb c = panorama_.radiance(column, row);
        const Turn turn = turns_[static_cast<std::size_t>(column)];
        const Row at = rows_[static_cast<std::size_t>(row)];
        return {at.ring * turn.cosine, at.up,         at.ring * turn.sine, 0.0f,
                at.area * c.r,         at.area * c.g, at.area * c.b,       at.area};
    }
    LightCellLevel coarser() const;
    LightCellLevel gathered(int width, int height) const;

    const Panorama& panorama_;
    std::vector<Turn> turns_; // by column
    std::vector<Row> rows_;
    std::vector<LightCellLevel> levels_;
};

} // namespace lambent::environment
