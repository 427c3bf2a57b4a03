// The columns of the G-buffer: what the passes leave each other of every fragment. A number is a column, a vector three in a
// row.
const int column_position = 0; // in the world, metres
const int column_view = 3;     // towards the viewer
const int column_depth = 6;    // metres from where the ray starts
const int column_lit = 7;      // 0: unlit, no pass gives it light
const int column_diffuse = 8;  // the report's Kd
const int column_specular = 11; // the report's Ks; else reflectance at normal incidence, for looking at
const int column_exponent = 14; // the report's

// Light.
const int column_direct = 15;
const int column_irradiance = 18;
const int column_ambient = 21;
const int column_reflected = 24;
const int column_middle_level = 27; // where layers are asked for: of the mips read in the lobe's middle, as a part of the highest
const int columns_of_light_end = 28;

// For the base and each lobe over it: shading normal, facing the viewer, and how the mirrored direction changes in a pixel.
const int column_shine = 28;
const int columns_per_shine = 9;

// The parameters of the material, in the order of material/parameters.h.
const int column_material = column_shine + columns_per_shine * (1 + layer_lobes);
const int column_count = column_material + parameter_numbers;
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) \
    const int column_##name = column_material + number;                   \
    const int column_##alpha = column_material + number + 3;
#define COLOR(name, number, value, object, key, texture) const int column_##name = column_material + number;
#define SCALAR(name, number, value, object, key, texture, channel) const int column_##name = column_material + number;
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) const int column_##name = column_material + number;
#define STRENGTH(name, factor, number, value, object, key, texture, channel) const int column_##name = column_material + number;
#include "shading/material/parameters.h"
