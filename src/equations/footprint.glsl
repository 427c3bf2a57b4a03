// The environment's blurs whose width fits a sample's footprint. The environment is stored as a chain of Gaussian blurs
// on the sphere: level l >= 1 has the angular variance v1 4^(l-1), level 0 is the panorama itself, of variance v1 / 16.
// (Isotropic Gaussians, not boxes: a box moves light by up to half a texel of its level, which at 40 samples is an
// error of 3 to 25% where Gaussians leave 2 to 8%.)

// The fractional level whose blend of two neighbours has the angular variance `variance` times v1. At least 0.
// Witness: the variance of the blend, over four decades.
Real level_of_variance(Real variance)
{
    Real below = (variance - 0.0625) * 1.0666666666666667;
    PowersOfFour p = powers_of_four(max(variance, 1.0));
    Real above = p.exponent + (p.mantissa * 0.3333333333333333 + 0.6666666666666667);
    return max(select(variance < 1.0, below, above), 0.0);
}

// A level as a fraction of the highest level, 0 to 1. Witness: the ends of a chain, and its middle.
Real part_of_levels(Real level, Real highest) { return clamp(level / max(highest, 1.0), 0.0, 1.0); }

// The variance of a Gaussian that covers one sample's share of a lobe. Each of N samples represents the solid angle
// `spread`, 1 / (N density); neighbours are sqrt(spread) apart, and a standard deviation of 0.55 of that gives the
// least error over a sphere. (Below 0.67 a sun shows each sample as a dot, but blurs that wide leave the sun out.)
// [footprint from density: Colbert and Krivanek 2007, GPU Gems 3 ch. 20; measured by tests/draw/specular_error_test]
// Witness: a lamp of a few degrees through a lobe of such samples has one maximum, and the lobe's shape.
Real variance_of_spread(Real spread) { return 0.3 * spread; }

// The share of the coarser level in a blend of two levels that has `variance`. levels: the variances of the finer (x)
// and the coarser level (y). Witness: the variance of the blend.
Real share_of_coarser(Real variance, vec2 levels)
{
    return clamp((variance - levels.x) / (levels.y - levels.x), 0.0, 1.0);
}

// Density per solid angle of a Gaussian on the sphere, of an angular variance up to about half a radian squared, from
// the squared chord to its centre. [Fisher 1953, "Dispersion on a sphere"]
// Witness: quadrature gives 1, and the variance.
Real gaussian_on_sphere(Real chord2, Real variance)
{
    Real kappa = 1.0 / variance;
    return 0.15915494309189535 * kappa * exp2(max(-0.7213475204444817 * kappa * chord2, -120.0)) /
           (1.0 - exp2(max(-2.8853900817779268 * kappa, -120.0)));
}

// The least cosine between the normals of visibility samples in a pixel that are shaded as one, where the surface's lobe
// has that alpha. The directions that two such normals mirror the view to differ by alpha at most, half a lobe's width;
// by a hundredth where alpha is less, so that a flat mirror is shaded once; by an angle of cosine `least` at most.
// Witness: the angle between mirrored directions.
Real shared_cosine(Real alpha, Real least) { return max(cos(0.5 * max(alpha, 0.01)), least); }
