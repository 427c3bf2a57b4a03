// The numbers of a material's textures, and how many rows the lists of this folder and of lobes/ have (which C++ holds them to:
// material/lists.h).
#define TEXTURE(name, number, transfer, object, key) const int texture_##name = number;
#define NORMAL_TEXTURE(name, number, object, key) const int texture_##name = number;
#include "shading/material/textures.h"
const int texture_count = 5;
const int parameter_numbers = 10;
const int layer_lobes = 0;
