// Integrals in double by adaptive Gauss-Legendre quadrature, for witnesses: shares nothing with the
// equations.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace lambent::test {

using std::numbers::pi;

// Eight-point rule on [a, b], exact for polynomials of degree 15. [Abramowitz and Stegun, table 25.4]
template <class F>
double gauss8(const F& f, double a, double b)
{
    constexpr std::array<double, 4> x = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                         0.9602898564975363};
    constexpr std::array<double, 4> w = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                         0.1012285362903763};
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
    double sum = 0.0;
    for (size_t i = 0; i < x.size(); i++)
        sum += w[i] * (f(middle - half * x[i]) + f(middle + half * x[i]));
    return half * sum;
}

struct Panel {
    double a, b, whole;
};

// A panel, halved until both halves together agree with the whole within `tolerance` (absolute).
template <class F>
double refine(const F& f, const Panel& panel, double tolerance, int depth)
{
    const double middle = 0.5 * (panel.a + panel.b);
    const double left = gauss8(f, panel.a, middle), right = gauss8(f, middle, panel.b);
    if (depth == 0 || std::abs(left + right - panel.whole) <= tolerance)
        return left + right;
    return refine(f, {panel.a, middle, left}, 0.5 * tolerance, depth - 1) +
           refine(f, {middle, panel.b, right}, 0.5 * tolerance, depth - 1);
}

// Integral of f over [a, b], with an estimated absolute error of `tolerance` for each of the panels to begin
// with: a narrow peak needs enough of them to be seen.
template <class F>
double integrate(const F& f, double a, double b, double tolerance = 1e-9, int panels = 4)
{
    double sum = 0.0;
    for (int i = 0; i < panels; i++) {
        const double from = a + (b - a) * i / panels, to = a + (b - a) * (i + 1) / panels;
        sum += refine(f, {from, to, gauss8(f, from, to)}, tolerance, 30);
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

// Integral over the whole sphere of f(x, y, z), smooth, per solid angle: Gauss in z, equal steps in azimuth
// (exact for trigonometric polynomials of degree below 64).
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
