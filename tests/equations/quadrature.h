// Integrals in double by Boost's adaptive Gauss-Kronrod quadrature, for witnesses: shares nothing with the equations.
#pragma once

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace lambent::test {

using std::numbers::pi;

// Integral of f over [a, b], with an estimated absolute error of `tolerance` for each of the panels to begin
// with: a narrow peak needs enough of them to be seen.
template <class F>
double integrate(const F& f, double a, double b, double tolerance = 1e-9, int panels = 4)
{
    using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
    constexpr unsigned halvings = 15;
    double sum = 0.0;
    for (int i = 0; i < panels; i++) {
        const double from = a + (b - a) * i / panels, to = a + (b - a) * (i + 1) / panels;
        double error = 0.0;
        const double whole = Rule::integrate(f, from, to, 0, 0.0, &error);
        // Boost's tolerance is relative to the whole.
        const double relative = whole != 0.0 ? tolerance / std::abs(whole) : tolerance;
        sum += error <= tolerance ? whole : Rule::integrate(f, from, to, halvings, relative);
    }
    return sum;
}

// The same between consecutive points of `breaks`, where f is not smooth or has its peak.
template <class F>
double integrate_between(const F& f, const std::vector<double>& breaks, double tolerance = 1e-9)
{
    double sum = 0.0;
    for (size_t i = 0; i + 1 < breaks.size(); i++)
        sum += integrate(f, breaks[i], breaks[i + 1], tolerance, 2);
    return sum;
}

// Integral over the hemisphere about +z of f(cosine), a function of the cosine to z alone, per solid angle.
// Peaks at the pole as narrow as 1e-5 radians are resolved: 1 - cosine = t^4.
template <class F>
double integrate_about_pole(const F& f, double tolerance = 1e-9)
{
    const auto of_t = [&](double t) { return f(1.0 - t * t * t * t) * 4.0 * t * t * t; };
    return 2.0 * pi * integrate(of_t, 0.0, 1.0, tolerance, 64);
}

// Integral over the whole sphere of f(x, y, z), smooth, per solid angle: in equal steps of azimuth (exact for trigonometric
// polynomials of degree below 64).
template <class F>
double integrate_sphere(const F& f)
{
    constexpr int steps = 64;
    const auto ring = [&](double z) {
        const double r = std::sqrt(1.0 - z * z);
        double sum = 0.0;
        for (int i = 0; i < steps; i++) {
            const double phi = 2.0 * pi * (i + 0.5) / steps;
            sum += f(r * std::cos(phi), r * std::sin(phi), z);
        }
        return sum * 2.0 * pi / steps;
    };
    return integrate(ring, -1.0, 1.0, 1e-12, 8);
}

} // namespace lambent::test
