// What colours the numbers of a file are of, and the way from there to Rec. 709.
#pragma once

#include <array>
#include <optional>

namespace lambent::image {

/// CIE 1931 x and y.
struct Chromaticity {
    double x, y;
};

/// Of the colours that one channel alone makes, and of that which all three make when they are 1. Rec. 709 if not given.
struct Primaries {
    Chromaticity red{0.64, 0.33}, green{0.30, 0.60}, blue{0.15, 0.06}, white{0.3127, 0.3290};
};

/// Rows of a matrix to be multiplied by (r, g, b).
using ColourMatrix = std::array<std::array<double, 3>, 3>;

/// To Rec. 709 with its white, D65: the white is adapted [Lam 1985, "Metamerism and colour constancy" (Bradford)], but with
/// the primaries (1, 0), (0, 1), (0, 0), by which OpenEXR marks CIE XYZ ("Technical Introduction to OpenEXR"), the numbers
/// are those tristimulus values and nothing is adapted. Nothing for primaries that are no triangle, and for values that are
/// not finite or a white without luminance.
std::optional<ColourMatrix> to_rec709(const Primaries& primaries);

/// Whether a matrix leaves colours as they are, to one in a thousand.
bool is_identity(const ColourMatrix& matrix);

} // namespace lambent::image
