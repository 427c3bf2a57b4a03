// The report's material written down a second time, in double, for witnesses.
#pragma once

#include "tests/equations/quadrature.h"

#include <glm/ext/vector_double3.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace lambent::reference::testing {

struct ClosedPhong {
    double diffuse, specular, exponent;

    // From the cosines between normal and half way, and view and half way.
    double glossy(double NH, double VH) const
    {
        const double F = specular + (1.0 - specular) * std::pow(1.0 - VH, 5.0);
        const double D = (exponent + 2.0) / (2.0 * std::numbers::pi) * std::pow(NH, exponent);
        return D * F / (4.0 * VH * VH);
    }

    /// BRDF, per steradian, for unit vectors.
    double brdf(const glm::dvec3& normal, const glm::dvec3& view, const glm::dvec3& light) const
    {
        const glm::dvec3 half = glm::normalize(view + light);
        return diffuse / std::numbers::pi + glossy(glm::dot(normal, half), glm::dot(view, half));
    }

    /// What is seen head on under light radiance(cosine to the normal).
    template <class F>
    double head_on(const F& radiance) const
    {
        const auto of_cosine = [&](double cosine) {
            const double half = std::sqrt(0.5 * (1.0 + cosine));
            return (diffuse / std::numbers::pi + glossy(half, half)) * radiance(cosine) * cosine;
        };
        return 2.0 * std::numbers::pi * test::integrate(of_cosine, 0.0, 1.0);
    }
};

} // namespace lambent::reference::testing
