// Trowbridge and Reitz's distribution written from slopes, and Smith's masking from it: another form than the
// text's.
#pragma once

#include "tests/equations/quadrature.h"

namespace lambent::test {

// Density of facet normals per solid angle. A facet of slope p, q has the density 1 / (pi alpha^2 (1 + (p^2 +
// q^2) / alpha^2)^2); slopes cover solid angle as 1 / cos^3, and the facet's own area is 1 / cos. [Heitz
// 2014, eq. 15, 84]
inline double facet_density(double cosine, double alpha)
{
    const double slope2 = (1.0 - cosine) * (1.0 + cosine) / (cosine * cosine);
    return 1.0 / (pi * alpha * alpha * std::pow(1.0 + slope2 / (alpha * alpha), 2.0) * std::pow(cosine, 4.0));
}

// Smith's Lambda in closed form. [Heitz 2014, eq. 72]
inline double smith_lambda(double cosine, double alpha)
{
    const double tangent = std::sqrt((1.0 - cosine) * (1.0 + cosine)) / cosine;
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * tangent * tangent) - 1.0);
}

// Area of the facets that face a view at cosine NV, projected towards it, by quadrature of the density alone:
// 1 + Lambda = that area / NV.
inline double facing_projected_area(double NV, double alpha)
{
    const double SV = std::sqrt((1.0 - NV) * (1.0 + NV));
    const auto ring = [&](double c) {
        const double a = NV * c, b = SV * std::sqrt((1.0 - c) * (1.0 + c));
        const double last = b > a ? std::acos(-a / b) : pi; // facets beyond this azimuth look away
        const auto towards = [&](double phi) { return a + b * std::cos(phi); };
        return c > 0.0 ? facet_density(c, alpha) * 2.0 * integrate(towards, 0.0, last, 1e-10, 1) : 0.0;
    };
    return integrate_about_pole(ring, 1e-9) / (2.0 * pi);
}

} // namespace lambent::test
