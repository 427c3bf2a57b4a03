// Loads and stores of fragments' values. Hooks: see README.md.

// The surface point with the normal of the base, number 0, or of a lobe over it.
ShinyPoint load_shine(Fragment f, int number)
{
    int column = column_shine + columns_per_shine * number;
    ShinyPoint s = {load3(f, column), load3(f, column_view), load3(f, column + 3), load3(f, column + 6)};
    return s;
}

// extent: side in pixels of the square that is shaded as one fragment.
void store_shine(Fragment f, int number, Surface s, Real extent)
{
    int column = column_shine + columns_per_shine * number;
    store3(f, column, s.normal);
    store3(f, column + 3, extent * s.mirrored_dx);
    store3(f, column + 6, extent * s.mirrored_dy);
}

Material load_material(Fragment f)
{
    Material m = {
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) \
    load3(f, column_##name), load(f, column_##alpha),
#define COLOR(name, number, value, object, key, texture) load3(f, column_##name),
#define SCALAR(name, number, value, object, key, texture, channel) load(f, column_##name),
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) load(f, column_##name),
#define STRENGTH(name, factor, number, value, object, key, texture, channel) load(f, column_##name),
#include "shading/material/parameters.h"
    };
    return m;
}

void store_material(Fragment f, Material m)
{
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) \
    store3(f, column_##name, m.name);                                     \
    store(f, column_##alpha, m.alpha);
#define COLOR(name, number, value, object, key, texture) store3(f, column_##name, m.name);
#define SCALAR(name, number, value, object, key, texture, channel) store(f, column_##name, m.name);
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) store(f, column_##name, m.name);
#define STRENGTH(name, factor, number, value, object, key, texture, channel) store(f, column_##name, m.name);
#include "shading/material/parameters.h"
}
