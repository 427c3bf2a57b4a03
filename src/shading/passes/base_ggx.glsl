// Metal and dielectric: GGX facets over a diffuse base. Hooks: see README.md.

struct Base_ggx {
    Metallic metallic;
    vec2 albedo; // of the facets (equations/energy.glsl)
};

Metallic metallic_of(Environment e, Material m)
{
    Metallic r = {m.base_color, m.metallic, vec2(m.alpha), vec3(0.0), compensation_of(e)};
    return r;
}

Base_ggx base_ggx(Environment e, Fragment f, ShinyPoint s)
{
    Material m = load_material(f);
    Base_ggx b = {metallic_of(e, m), albedo_of(dot(s.normal, s.view), m.alpha)};
    return b;
}

vec3 direct_base(Environment e, Base_ggx b, ShinyPoint s, Arrival a)
{
    return direct_metallic_in_pixel(b.metallic, b.albedo, s, a);
}

vec3 ambient_base(Environment e, Base_ggx b, vec3 irradiance, Real brightness)
{
    return ambient_light(reflectance_metallic(b.metallic, b.albedo).diffuse, irradiance, brightness);
}

vec3 reflected_base(Environment e, Base_ggx b, ShinyPoint s) { return reflected_metallic(e, b.metallic, s); }

Real level_of_base(Environment e, Base_ggx b, ShinyPoint s)
{
    return part_of_levels(middle_level_ggx(e, mirror_at(e, s, b.metallic)), highest_level(e));
}

// Luminance of what the base reflects diffusely (x) and by its glossy lobe (y), of white light from everywhere.
vec2 parts_of_base(Base_ggx b)
{
    Reflectance r = reflectance_metallic(b.metallic, b.albedo);
    return vec2(luminance_of(r.diffuse), luminance_of(r.plain + r.grazing));
}

vec3 drawn_by_base(Base_ggx b, ShinyPoint s, vec3 point) { return drawn_by_facets(b.metallic, s, point); }

Real density_by_base(Base_ggx b, ShinyPoint s, vec3 L) { return density_by_facets(b.metallic, s, L); }
