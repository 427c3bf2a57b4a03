// The numbers of a material's textures, and the counts of textures, of parameters' values and of lobes over the base.
#define TEXTURE(name, number, transfer, object, key) const int texture_##name = number;
#define NORMAL_TEXTURE(name, number, object, key) const int texture_##name = number;
#include "shading/material/textures.h"

const int texture_count = 0
#define TEXTURE(name, number, transfer, object, key) +1
#define NORMAL_TEXTURE(name, number, object, key) +1
#include "shading/material/textures.h"
    ;

const int parameter_numbers = 0
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) +4
#define COLOR(name, number, value, object, key, texture) +3
#define SCALAR(name, number, value, object, key, texture, channel) +1
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) +1
#define STRENGTH(name, factor, number, value, object, key, texture, channel) +1
#include "shading/material/parameters.h"
    ;

const int layer_lobes = 0
#define LAYER(name, number, normal) +1
#include "shading/lobes/layers.h"
    ;
