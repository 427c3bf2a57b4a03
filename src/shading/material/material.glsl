// From texels to the parameters of a material at a point. Needs no hooks.

// A texture's value at a point, linear.
struct Texel {
    Real r;
    Real g;
    Real b;
    Real a;
};

// The values of all textures of a material at a point, 1 for missing ones.
struct Texels {
#define TEXTURE(name, number, transfer, object, key) Texel name;
#define NORMAL_TEXTURE(name, number, object, key) Texel name;
#include "shading/material/textures.h"
};

// The factors of a material, or its parameters at a point.
struct Material {
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) \
    vec3 name;                                                            \
    Real alpha;
#define COLOR(name, number, value, object, key, texture) vec3 name;
#define SCALAR(name, number, value, object, key, texture, channel) Real name;
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) Real name;
#define STRENGTH(name, factor, number, value, object, key, texture, channel) Real name;
#include "shading/material/parameters.h"
};

// alpha of a lobe, at least 0.0001: floats do not resolve narrower lobes. Witness: squares (tests/equations).
Real alpha_of_roughness(Real roughness) { return max(roughness * roughness, 1.0e-4); }

// Opacity of a surface by its alpha mode. texel: alpha of the texture, for masks the opaque share; product: that of
// texture, vertex colour and factor. [glTF 2.0, 3.9.4] Witness: the three modes (tests/equations).
Real opacity_of(int mode, Real texel, Real product)
{
    if (mode == alpha_opaque)
        return 1.0;
    if (mode == alpha_mask)
        return texel;
    return product;
}

// The parameters at a point. vertex: the mesh's colour there, which multiplies the base colour's texel; mode: alpha
// mode. [glTF 2.0, 3.9.2 and 3.9.3] Witness: each parameter by its own channel alone (tests/equations).
Material material_of(Material factors, Texels t, Texel vertex, int mode)
{
    Material m = {
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture)                                          \
    vec3((t.texture.r * vertex.r) * factors.name.x, (t.texture.g * vertex.g) * factors.name.y,                     \
         (t.texture.b * vertex.b) * factors.name.z),                                                               \
        opacity_of(mode, t.texture.a, (t.texture.a * vertex.a) * factors.alpha),
#define COLOR(name, number, value, object, key, texture) factors.name * vec3(t.texture.r, t.texture.g, t.texture.b),
#define SCALAR(name, number, value, object, key, texture, channel) clamp(t.texture.channel * factors.name, 0.0, 1.0),
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel)                                      \
    alpha_of_roughness(clamp(t.texture.channel * factors.name, 0.0, 1.0)),
#define STRENGTH(name, factor, number, value, object, key, texture, channel)                                       \
    1.0 + factors.name * (t.texture.channel - 1.0),
#include "shading/material/parameters.h"
    };
    return m;
}
