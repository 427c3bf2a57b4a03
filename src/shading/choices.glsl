// Settings of lighting, as numbers shared by C++ and shaders.
#define BASE(name, number, layered) const int model_##name = number;
#include "shading/passes/bases.h"
const int levels_matched = 0;
const int levels_report = 1;
const int levels_pipeline = 2; // the report's, in its own order of operations
const float small_share = 0.375; // fragments that cover less of a pixel take fewer samples
const int alpha_opaque = 0; // alpha modes of a material [glTF 2.0, 3.9.4]
const int alpha_mask = 1;
const int alpha_blend = 2;
const int background_none = 0;
const int background_color = 1;
const int background_panorama = 2;
const int background_blurred = 3;
