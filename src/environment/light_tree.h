// A panorama's light in cells, coarser from level to level: far from a direction, or for a wide lobe, one cell stands for
// many texels. [Barnes and Hut 1986, "A hierarchical O(N log N) force-calculation algorithm"]
#pragma once

#include "environment/panorama.h"

#include <vector>

namespace lambent::environment {

/// Cells of one size, row by row as the panorama.
struct LightCellLevel {
    int width = 0, height = 0;
    std::vector<float> x, y, z;  ///< direction of the middle of each cell's light, unit length
    std::vector<float> r, g, b;  ///< its light: radiance times solid angle
    std::vector<float> variance; ///< of its light about that direction, angular, per axis, square radians
    std::vector<float> extent;   ///< [row]: the longer side of its cells, radians
};

/// Levels from the finest on; each has a quarter of the cells of the one before, the last at most 32x16.
struct LightTree {
    std::vector<LightCellLevel> levels;
};

/// Cells no larger than `extent` radians if the texels are no larger: at most 2048x1024, else the texels' own size.
LightTree make_light_tree(const Panorama& panorama, double extent);

} // namespace lambent::environment
