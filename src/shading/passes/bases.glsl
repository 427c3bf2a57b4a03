// What a shading model allows.

// 1 if lobes may lie over a model's base, else 0. Witness: the list (passes/bases.h).
int takes_layers(int model)
{
    int takes = 0;
#define BASE(name, number, layered) \
    if (model == number)            \
        takes = layered;
#include "shading/passes/bases.h"
    return takes;
}
