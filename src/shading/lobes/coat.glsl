// Facets of a clear coat over all other lobes: a dielectric of index 1.5, without a base. [KHR_materials_clearcoat]
// Witness: value and albedo by another form of GGX (tests/reference).
Metallic facets_coat(Material m, Real compensation)
{
    Metallic f = {vec3(0.0), 0.0, vec2(m.coat_alpha), vec3(0.0), compensation};
    return f;
}
