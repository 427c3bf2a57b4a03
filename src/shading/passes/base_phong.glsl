// The report's model, in three variants: the environment is read at levels that match the samples, or at the report's
// own levels, or in the report's own order of operations (lobes/pipeline_report.glsl). Hooks: see README.md.

struct Base_phong {
    Phong phong;
};

Base_phong base_phong(Environment e, Fragment f, ShinyPoint s)
{
    Phong p = {load3(f, column_diffuse), load3(f, column_specular), load(f, column_exponent)};
    Base_phong b = {p};
    return b;
}

// The report's own order of operations evaluates the light once for each fragment, as the report does.
vec3 direct_base(Environment e, Base_phong b, ShinyPoint s, Arrival a)
{
    if (levels_of(e) == levels_pipeline)
        return direct_phong(b.phong, s.normal, s.view, a);
    return direct_phong_in_pixel(b.phong, s, a);
}

vec3 ambient_base(Environment e, Base_phong b, vec3 irradiance, Real brightness)
{
    if (levels_of(e) == levels_pipeline)
        return ambient_report(report_tone(e), b.phong.diffuse, irradiance, brightness);
    return ambient_light(b.phong.diffuse, irradiance, brightness);
}

vec3 reflected_base(Environment e, Base_phong b, ShinyPoint s)
{
    ShinyPoint t = in_environment(e, s);
    vec3 across = turned(e, across_of(e));
    if (levels_of(e) == levels_pipeline)
        return specular_pipeline_report(e, report_tone(e), b.phong, t.normal, t.view, across);
    if (levels_of(e) == levels_report)
        return specular_phong_report(e, b.phong, t.normal, t.view, across);
    return specular_phong(e, b.phong, t, across);
}

Real level_of_base(Environment e, Base_phong b, ShinyPoint s)
{
    Real exponent = b.phong.exponent;
    if (levels_of(e) == levels_pipeline)
        return part_of_levels(middle_level_pipeline(e, exponent), highest_report_level(e));
    if (levels_of(e) == levels_report)
        return part_of_levels(middle_level_report(e, exponent), highest_report_level(e));
    return part_of_levels(middle_level_phong(e, in_environment(e, s), exponent), highest_level(e));
}

// Luminance of what the base reflects diffusely (x) and, at normal incidence, by its glossy lobe (y).
vec2 parts_of_base(Base_phong b)
{
    return vec2(luminance_of(b.phong.diffuse), luminance_of(b.phong.specular));
}

vec3 drawn_by_base(Base_phong b, ShinyPoint s, vec3 point) { return drawn_by_phong(b.phong, s, point); }

Real density_by_base(Base_phong b, ShinyPoint s, vec3 L) { return density_by_phong(b.phong, s, L); }
