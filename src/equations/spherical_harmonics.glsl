// Irradiance as nine coefficients. Real spherical harmonics of bands 0 to 2 in the order
// 1; y, z, x; xy, yz, 3z^2-1, xz, x^2-y^2. [Ramamoorthi and Hanrahan 2001, "An efficient representation for
// irradiance environment maps", eq. 3]

// One value for each harmonic: the harmonics themselves at a direction, or one colour channel's coefficients.
struct Harmonics {
    Real c0;
    Real c1;
    Real c2;
    Real c3;
    Real c4;
    Real c5;
    Real c6;
    Real c7;
    Real c8;
};

// The harmonics at the unit direction d. Witness: orthonormality by quadrature.
Harmonics harmonics(vec3 d)
{
    Harmonics h = {Real(0.28209479177387814),
                   0.4886025119029199 * d.y,
                   0.4886025119029199 * d.z,
                   0.4886025119029199 * d.x,
                   1.0925484305920792 * d.x * d.y,
                   1.0925484305920792 * d.y * d.z,
                   0.31539156525252005 * (3.0 * d.z * d.z - 1.0),
                   1.0925484305920792 * d.x * d.z,
                   0.5462742152960396 * (d.x * d.x - d.y * d.y)};
    return h;
}

// Irradiance on a surface of normal N from the coefficients L of radiance: each band times the clamped cosine's
// pi, 2 pi / 3, pi / 4. [Ramamoorthi and Hanrahan 2001, eq. 8-9] May be negative for hard light; the caller clamps.
// Witness: radiance that is itself a harmonic of band 0 to 2.
Real harmonic_irradiance(Harmonics L, vec3 N)
{
    Harmonics h = harmonics(N);
    Real band0 = L.c0 * h.c0;
    Real band1 = L.c1 * h.c1 + L.c2 * h.c2 + L.c3 * h.c3;
    Real band2 = L.c4 * h.c4 + L.c5 * h.c5 + L.c6 * h.c6 + L.c7 * h.c7 + L.c8 * h.c8;
    return 3.141592653589793 * band0 + 2.0943951023931953 * band1 + 0.7853981633974483 * band2;
}
