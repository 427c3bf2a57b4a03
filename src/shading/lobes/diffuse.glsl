// Diffuse light from all around. Needs no hooks.

// What a surface sends on of the irradiance around it: the report's Kd, or what reflectance_metallic says is diffuse,
// over pi; `brightness` is a factor on it (the report's is 2). [Lambert 1760]
// Witness: closed form under a coloured sky (tests/draw).
vec3 ambient_light(vec3 diffuse, vec3 irradiance, Real brightness)
{
    return (0.3183098861837907 * brightness) * diffuse * irradiance;
}
