// Bindings, constants and records shared by the shader that prefilters environments and the C++ code that runs it.

const int bake_cells = 0;      // LightCell as two vectors: direction, variance; light, area
const int bake_bounds = 1;     // Prefilter::Bounds by depth and row: far, far_bright, reach, fine_at_horizon (0 or 1)
const int bake_levels = 2;     // per depth, finest first: first cell, first row, columns, rows
const int bake_directions = 3; // 64 per tile
const int bake_results = 4;
const int bake_binding_count = 5;

const int bake_constant_lobe = 0;
const int bake_lobe_ggx = 0;
const int bake_lobe_phong = 1;

// Push constants. A cell whose light and area have different centres is followed, at the end of the buffer, by a cell
// with the area: at index i, which is stored as the area -1 - i.
struct BakeConstants {
    vec4 lobe;   // alpha^2 or the Phong exponent; the lobe's integral; Prefilter::much_light(); bright_radiance()
    ivec4 place; // first tile; first row of the bounds; number of depths
};
