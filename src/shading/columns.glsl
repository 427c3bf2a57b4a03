// Columns of the G-buffer: the values of every fragment that one pass stores and others load. A number takes one
// column, a vector three consecutive ones.
const int column_position = 0; // in world space, metres
const int column_view = 3;     // towards the viewer
const int column_depth = 6;    // distance from the ray's origin, metres
const int column_lit = 7;      // 0: unlit, no pass adds light
const int column_diffuse = 8;  // the report's Kd
const int column_specular = 11; // the report's Ks; else reflectance at normal incidence, for display as a layer
const int column_exponent = 14; // the report's

// Results of the light passes.
const int column_direct = 15;
const int column_irradiance = 18;
const int column_ambient = 21;
const int column_reflected = 24;
const int column_middle_level = 27; // if layers are requested: mip level read at the lobe's centre / highest
const int columns_of_light_end = 28;

// For the base and each lobe over it: shading normal, facing the viewer, and changes of the mirrored direction in a
// pixel.
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
