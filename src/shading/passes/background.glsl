// The background behind all surfaces. Hooks: see README.md.

// `sum` plus the lamps through a level's blur, times the level's weight `share`. d: in the environment's own frame.
vec3 with_lamps_blurred(Environment e, vec3 d, vec3 sum, Real share, Real variance)
{
    for (int i = 0; i < lamp_count(e); ++i) {
        vec3 off = d - lamp_direction(e, i);
        sum += (share * gaussian_on_sphere(dot(off, off), variance + lamp_variance(e, i))) * lamp_light(e, i);
    }
    return sum;
}

// The background in a world direction: the panorama, or its blur interpolated between two levels.
vec3 background_light(Environment e, vec3 direction)
{
    vec3 d = turned(e, direction);
    vec3 light = vec3(0.0);
    if (background_of(e) == background_panorama)
        light = environment_panorama(e, d);
    else {
        vec3 lamps = vec3(0.0);
        for (int i = 0; i < 2; ++i)
            if (is_without_lamps(e, i) != 0)
                lamps = with_lamps_blurred(e, d, lamps, share_of_level(e, i), variance_of_level(e, i));
        light = environment_blurred(e, d) + lamps;
    }
    if (levels_of(e) == levels_pipeline)
        light = toned_report(report_tone(e), light);
    return light;
}
