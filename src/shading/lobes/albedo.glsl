// The directional albedo of GGX, from the table of src/albedo. Hook: albedo_entry, see README.md.
const int albedo_points = 64; // entries along each axis of the table

// The two parts of the albedo (equations/energy.glsl) at a cosine and alpha, interpolated between the table's entries.
// Witness: quadrature of the table's definition, in double (tests/environment).
vec2 albedo_of(Real NV, Real alpha)
{
    Real last = Real(albedo_points - 1);
    Real x = sqrt(clamp(NV, 0.0, 1.0)) * last;
    Real y = sqrt(sqrt(clamp(alpha * alpha, 0.0, 1.0))) * last;
    Real x0 = min(floor(x), last - 1.0);
    Real y0 = min(floor(y), last - 1.0);
    Real fx = x - x0;
    Real fy = y - y0;
    Real x1 = x0 + 1.0;
    Real y1 = y0 + 1.0;
    return vec2(mix(mix(albedo_entry(x0, y0, 0), albedo_entry(x1, y0, 0), fx),
                    mix(albedo_entry(x0, y1, 0), albedo_entry(x1, y1, 0), fx), fy),
                mix(mix(albedo_entry(x0, y0, 1), albedo_entry(x1, y0, 1), fx),
                    mix(albedo_entry(x0, y1, 1), albedo_entry(x1, y1, 1), fx), fy));
}
