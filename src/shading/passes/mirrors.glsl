// Reflection of the environment, with directions transformed from world space to its own frame. Hooks: see README.md.

// The surface point in the environment's own frame.
ShinyPoint in_environment(Environment e, ShinyPoint s)
{
    ShinyPoint t = {turned(e, s.normal), turned(e, s.view), turned(e, s.mirrored_dx), turned(e, s.mirrored_dy)};
    return t;
}

Mirror mirror_at(Environment e, ShinyPoint s, Metallic facets)
{
    ShinyPoint t = in_environment(e, s);
    Mirror m = {t, turned(e, across_of(e)), facets.alpha, turned(e, facets.tangent),
                albedo_of(dot(t.normal, t.view), facets.alpha.x)};
    return m;
}

ONE_BODY vec3 reflected_metallic(Environment e, Metallic m, ShinyPoint s)
{
    Mirror mirror = mirror_at(e, s, m);
    LobeLight light = specular_ggx(e, mirror);
    Reflectance r = reflectance_metallic(m, mirror.albedo);
    return r.plain * light.plain + r.grazing * light.grazing;
}
