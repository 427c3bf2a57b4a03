// What the shader that prefilters environments and its program agree on.

const int bake_cells = 0;      // LightCell as two vectors: direction, variance; light, area
const int bake_bounds = 1;     // per row of each depth: far, far where much light is, reach; w: 1 if fine at the horizon
const int bake_levels = 2;     // per depth, finest first: first cell, first row, columns, rows
const int bake_directions = 3; // 64 to a tile
const int bake_results = 4;
const int bake_binding_count = 5;

const int bake_constant_lobe = 0;
const int bake_lobe_ggx = 0;
const int bake_lobe_phong = 1;

// Where a cell's light and its area have different middles, its area is -1 - the cell that has it.
struct BakeConstants {
    vec4 lobe;   // alpha^2, or the exponent; integral; much light; radiance of bright cells
    ivec4 place; // first tile; first row of the bounds; depths
};
