// A coat of clear lacquer over everything else: facets of a dielectric of index 1.5 over nothing. [KHR_materials_clearcoat]
// Witness: its value and its albedo by another form of GGX (tests/reference).
Metallic facets_coat(Material m, Real compensation)
{
    Metallic f = {vec3(0.0), 0.0, vec2(m.coat_alpha), vec3(0.0), compensation};
    return f;
}
