// Diffuse reflection of irradiance. Needs no hooks.

// Radiance that a surface reflects diffusely: reflectance / pi times irradiance. diffuse: the report's Kd, or the
// diffuse part of reflectance_metallic; brightness: an additional factor (the report's is 2). [Lambert 1760]
// Witness: closed form under a coloured sky (tests/draw).
vec3 ambient_light(vec3 diffuse, vec3 irradiance, Real brightness)
{
    return (0.3183098861837907 * brightness) * diffuse * irradiance;
}
