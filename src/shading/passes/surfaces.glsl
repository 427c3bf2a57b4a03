// From a fragment's triangle to its surface: position, normals, material. Hooks: see README.md.

vec3 interpolated(Corners v, Barycentric at) { return at.a * v.a + at.b * v.b + at.c * v.c; }

// Change of the interpolated value if the weights of corners 1 and 2 change by b and c.
vec3 changed(Corners v, Real b, Real c) { return b * (v.b - v.a) + c * (v.c - v.a); }

Turning turning_at(Source s, Barycentric at)
{
    Corners normals = corner_normals(s);
    mat3 to_world = normals_to_world(s);
    return turning_of(to_world * interpolated(normals, at), to_world * changed(normals, at.b_dx, at.c_dx),
                      to_world * changed(normals, at.b_dy, at.c_dy));
}

// The normal with the normal map applied, if the material has it.
vec3 bumped(Source s, Barycentric at, vec3 normal, Texel code, int texture)
{
    vec3 mapped = normal;
    if (has_normal_map(s, texture) != 0)
        mapped = mapped_normal(normal, tangent_at(s, at), tangent_side(s), vec3(code.r, code.g, code.b),
                               normal_scale(s, texture));
    return mapped;
}

// The report's parameters: those that are given, else the approximation of metal and dielectric.
Phong phong_of(Material m, GivenPhong g)
{
    Phong made = phong_from_metallic(m.base_color, m.metallic, m.alpha);
    Phong p = {select(g.given.x > 0.5, g.diffuse, made.diffuse), select(g.given.y > 0.5, g.specular, made.specular),
               select(g.given.z > 0.5, g.exponent, made.exponent)};
    return p;
}

void store_models(Fragment f, Source s, Material m)
{
    if (model_of(s) == model_phong) {
        Phong p = phong_of(m, given_phong(s));
        store3(f, column_diffuse, p.diffuse);
        store3(f, column_specular, p.specular);
        store(f, column_exponent, p.exponent);
    } else
        store3(f, column_specular, base_reflectance(m.base_color, m.metallic));
}

// A visible point of a triangle, and the mesh's own normal there.
struct SeenPoint {
    SightRay sight;
    Facet facet;
    Turning turning;
};

// The surface with the normal map applied, if the material has it.
Surface mapped_surface(Source s, SeenPoint seen, Texel code, int texture)
{
    vec3 normal = bumped(s, seen.facet.at, seen.turning.normal, code, texture);
    return surface_at(seen.sight, seen.facet, seen.turning, normal, handedness(s));
}

// Stores all values that the light passes load. extent: side in pixels of the square that is shaded as one fragment.
void find_surface(Fragment f, Source s, Real extent)
{
    SightRay sight = sight_of(s);
    Triangle triangle = triangle_of(s);
    Facet facet = facet_at(sight, triangle, meeting_of(s, sight, triangle));
    SeenPoint seen = {sight, facet, turning_at(s, facet.at)};
    Texel vertex = vertex_color(s, facet.at);
    Texels texels = texels_of(s, facet.at, vertex);
    Material m = material_of(factors_of(s), texels, vertex, alpha_mode(s));
    m.alpha = own_or_given_alpha(s, m.alpha);
    Surface base = mapped_surface(s, seen, texels.normal, texture_normal);
    store3(f, column_position, facet.position);
    store(f, column_depth, base.depth);
    store3(f, column_view, base.view);
    store_shine(f, 0, base, extent);
#define LAYER(name, number, texture)                                                                         \
    if (has_layers() != 0 && takes_layers(model_of(s)) != 0 && any_of(m.name > 0.0)) {                       \
        Surface over = mapped_surface(s, seen, texels.texture, texture_##texture);                           \
        store_shine(f, number, over, extent);                                                                \
        m.emissive = left_below_at(m.name, facets_##name(m, compensation_of(s)), over.normal, over.view) *    \
                     m.emissive;                                                                             \
    }
#include "shading/lobes/layers.h"
    store_models(f, s, m);
    Real lit = 1.0;
    if (is_unlit(s) != 0) { // it emits its colour [KHR_materials_unlit]
        m.emissive = m.base_color;
        lit = 0.0;
    }
    store_material(f, m);
    store(f, column_lit, lit);
}
