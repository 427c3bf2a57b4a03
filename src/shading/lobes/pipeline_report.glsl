// The report's own order of operations: values read from the environment are decoded, exposed, changed by the tone
// curve and encoded before they light a surface. Its passes therefore add code values, not light (docs/REPORT.md).
// Hooks: see README.md.

// The ambient pass, diffuse^decode / pi * irradiance * brightness, where toned_report was applied to the irradiance.
// Witness: closed form (tests/equations).
vec3 ambient_report(ReportTone t, vec3 diffuse, vec3 irradiance, Real brightness)
{
    return ambient_light(power(diffuse, t.decode), toned_report(t, irradiance), brightness);
}

// The first term of the level 1/2 log2(W H / N) - 1/2 log2 D(H), less 1, because report_level_phong divides D by 4.
// Witness: the levels at which the pass below reads (tests/equations).
Real first_term_of_pipeline(Environment environment) { return first_term_of_report(environment) - 1.0; }

// The level at the lobe's centre, for display as a layer. Witness: the report's formula (tests/equations).
Real middle_level_pipeline(Environment environment, Real exponent)
{
    return report_level_phong(first_term_of_pipeline(environment), 1.0, exponent);
}

// The specular pass: the mean of F / (4 (w.H)^2) max(N.w, 0) times the value read in each direction w, to the power
// `back`. Witness: the sum over the values that were read, in double (tests/equations).
vec3 specular_pipeline_report(Environment environment, ReportTone t, Phong p, vec3 N, vec3 V, vec3 across)
{
    mat3 lobe = carried_frame(mirrored(N, V), V, across);
    Real first_term = first_term_of_pipeline(environment);
    vec3 total = vec3(0.0);
    for (int i = 0; i < sample_count(environment); ++i) {
        PhongSample s = phong_sample(N, V, lobe * sample_phong(lobe_point(environment, i), p.exponent));
        Real level = report_level_phong(first_term, s.NH, p.exponent);
        vec3 weight = s.weights.x * p.specular + vec3(s.weights.y);
        total += weight * toned_report(t, environment_report_texel(environment, s.direction, level));
    }
    return power(total / Real(sample_count(environment)), t.back);
}
