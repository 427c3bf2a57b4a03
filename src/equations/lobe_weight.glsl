// The weights by which prefiltering averages an environment: a lobe seen along its axis, R = N = V.

// A weight, and half its Laplacian on the sphere: light of a small angular variance v has the mean weight
// value + v curvature.
struct LobeWeight {
    Real value;
    Real curvature;
};

// GGX: cosine / q^2, q = alpha^2 + (1 - alpha^2) (1 - cosine) / 2, up to a constant D(h) N.L with h half way between N
// and L. c: the cosine, above 0; versine: 1 - c, exact where the lobe is narrow. Half the Laplacian of f(c) on the
// sphere is ((1 - c^2) f'' - 2 c f') / 2. Witness: differences of the definition.
LobeWeight lobe_weight_ggx(Real c, Real versine, Real alpha2)
{
    Real b = 0.5 - 0.5 * alpha2;
    Real p = 1.0 / (b * versine + alpha2);
    Real s2 = versine * (2.0 - versine);
    Real bp = b * p;
    Real bracket = c * (3.0 * bp * bp * s2 - 1.0) + 2.0 * bp * (s2 - c * c);
    LobeWeight w = {c * p * p, p * p * bracket};
    return w;
}

// The report's lobe: cosine^exponent. Witness: differences of the definition.
LobeWeight lobe_weight_phong(Real c, Real versine, Real exponent)
{
    Real safe = max(c, 1.0e-6);
    Real value = exp2(max(exponent * log2(safe), -120.0));
    Real s2 = versine * (2.0 - versine);
    Real inverse2 = 1.0 / (safe * safe);
    LobeWeight w = {value, value * exponent * ((0.5 * exponent - 0.5) * s2 * inverse2 - 1.0)};
    return w;
}

// Sums over cells of light times weight, and of solid angle times weight.
struct LobeSum {
    vec3 light;
    Real weight;
};

// The mean over the lobe. All weights should add up to the lobe's integral; a difference is ascribed to the dim cells,
// which are coarse, and their light is scaled to the weight that is left to them. So uniform light stays uniform, and a
// sun is not dimmed by the sky around it. Witness: uniform light, however unevenly it was summed; a sun beside it.
vec3 mean_of_lobe(LobeSum dim, LobeSum bright, Real integral)
{
    Real least = 0.05 * integral;
    Real left = (integral - bright.weight) / max(dim.weight, least);
    Real factor = select(dim.weight < least, 1.0, clamp(left, 0.9, 1.1));
    return (1.0 / integral) * (bright.light + factor * dim.light);
}
