// The colours of FLIP: from linear Rec. 709 light in [0, 1] to a space in which distances are perceived differences.
//
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild 2020, "FLIP: A Difference Evaluator for Alternating
// Images", HPG, sections 4.1.1 to 4.1.4. All numbers here are that paper's unless another source is named.
#pragma once

#include <array>
#include <cmath>

namespace lambent::compare {

/// Rows of a 3x3 matrix.
using Matrix3 = std::array<std::array<double, 3>, 3>;

/// From linear Rec. 709 to CIE XYZ divided by the white's, so that white is 1, 1, 1. The exact fractions that the
/// primaries and the white (0.3127, 0.3290) of IEC 61966-2-1 give. Rows add up to 1.
inline constexpr Matrix3 rgb_to_xyz = [] {
    constexpr Matrix3 absolute = {
        {{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
         {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
         {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}}};
    Matrix3 relative = absolute;
    for (auto& row : relative) {
        const double white = row[0] + row[1] + row[2];
        for (double& part : row)
            part /= white;
    }
    return relative;
}();

/// The inverse, by cofactors.
inline constexpr Matrix3 xyz_to_rgb = [] {
    const Matrix3& m = rgb_to_xyz;
    Matrix3 cofactors{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t r = (i + 1) % 3, s = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
            cofactors[j][i] = m[r][c] * m[s][d] - m[r][d] * m[s][c];
        }
    const double determinant =
        m[0][0] * cofactors[0][0] + m[0][1] * cofactors[1][0] + m[0][2] * cofactors[2][0];
    for (auto& row : cofactors)
        for (double& part : row)
            part /= determinant;
    return cofactors;
}();

struct Color {
    float x, y, z;
};

inline Color transformed(const Matrix3& m, const Color& c)
{
    const auto row = [&](std::size_t i) {
        return static_cast<float>(m[i][0]) * c.x + static_cast<float>(m[i][1]) * c.y +
               static_cast<float>(m[i][2]) * c.z;
    };
    return {row(0), row(1), row(2)};
}

/// CIE L*a*b* from XYZ relative to white, a and b scaled by L / 100: colours count for less where it is dark (the Hunt
/// effect, section 4.1.3).
Color hunt_lab(const Color& xyz);

/// |dL| + sqrt(da^2 + db^2), for large differences (Abasi, Amani Tehran, Fairchild 2020; section 4.1.3).
inline float hyab(const Color& p, const Color& q)
{
    return std::fabs(p.x - q.x) + std::sqrt((p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z));
}

/// A HyAB distance as an error in [0, 1]: its power q_c = 0.7, then linear so that p_c = 0.4 of the largest power (that
/// of green against blue) becomes p_t = 0.95, and the rest is mapped to the remaining range (section 4.1.4).
float color_error(float hyab_distance);

} // namespace lambent::compare
