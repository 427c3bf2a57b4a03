#include "image/openexr/primaries.h"

#include <cmath>
#include <cstddef>

namespace lambent::image {
namespace {

using Column = std::array<double, 3>;

// The Bradford matrix by rows. [Lam 1985]
constexpr ColourMatrix bradford = {
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

ColourMatrix product(const ColourMatrix& a, const ColourMatrix& b)
{
    ColourMatrix result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k)
                result[i][j] += a[i][k] * b[k][j];
    return result;
}

Column product(const ColourMatrix& a, const Column& v)
{
    Column result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            result[i] += a[i][k] * v[k];
    return result;
}

// The inverse by cofactors; nothing if the determinant is nearly 0.
std::optional<ColourMatrix> inverse(const ColourMatrix& m)
{
    const auto cofactor = [&m](std::size_t i, std::size_t j) {
        const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
        return m[a][c] * m[b][d] - m[a][d] * m[b][c];
    };
    double determinant = 0.0;
    for (std::size_t j = 0; j < 3; ++j)
        determinant += m[0][j] * cofactor(0, j);
    if (!(std::fabs(determinant) > 1e-6))
        return std::nullopt;
    ColourMatrix result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            result[j][i] = cofactor(i, j) / determinant;
    return result;
}

// XYZ of a white with luminance 1.
Column tristimulus(const Chromaticity& white)
{
    return {white.x / white.y, 1.0, (1.0 - white.x - white.y) / white.y};
}

// [SMPTE RP 177-1993, "Derivation of basic television color equations"]
std::optional<ColourMatrix> to_xyz(const Primaries& p)
{
    ColourMatrix m{};
    const Chromaticity primaries[3] = {p.red, p.green, p.blue};
    for (std::size_t j = 0; j < 3; ++j) {
        m[0][j] = primaries[j].x;
        m[1][j] = primaries[j].y;
        m[2][j] = 1.0 - primaries[j].x - primaries[j].y;
    }
    const std::optional<ColourMatrix> inverted = inverse(m);
    if (!inverted || !(p.white.y > 1e-6))
        return std::nullopt;
    const Column scale = product(*inverted, tristimulus(p.white));
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i)
            m[i][j] *= scale[j];
    return m;
}

std::optional<ColourMatrix> adaptation(const Chromaticity& from, const Chromaticity& to)
{
    const Column a = product(bradford, tristimulus(from)), b = product(bradford, tristimulus(to));
    ColourMatrix gain{};
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(a[i] > 1e-6))
            return std::nullopt;
        gain[i][i] = b[i] / a[i];
    }
    return product(*inverse(bradford), product(gain, bradford));
}

bool is_xyz(const Primaries& p)
{
    return p.red.x == 1.0 && p.red.y == 0.0 && p.green.x == 0.0 && p.green.y == 1.0 && p.blue.x == 0.0 &&
           p.blue.y == 0.0;
}

} // namespace

std::optional<ColourMatrix> to_rec709(const Primaries& primaries)
{
    for (const Chromaticity& c : {primaries.red, primaries.green, primaries.blue, primaries.white})
        if (!std::isfinite(c.x) || !std::isfinite(c.y))
            return std::nullopt;
    const ColourMatrix from_xyz = *inverse(*to_xyz(Primaries{}));
    if (is_xyz(primaries))
        return from_xyz;
    const std::optional<ColourMatrix> xyz = to_xyz(primaries);
    const std::optional<ColourMatrix> adapted =
        xyz ? adaptation(primaries.white, Primaries{}.white) : std::nullopt;
    if (!adapted)
        return std::nullopt;
    return product(from_xyz, product(*adapted, *xyz));
}

bool is_identity(const ColourMatrix& matrix)
{
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            if (!(std::fabs(matrix[i][j] - (i == j ? 1.0 : 0.0)) < 1e-3))
                return false;
    return true;
}

} // namespace lambent::image
