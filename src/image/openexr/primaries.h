// The primaries of an RGB colour space and its conversion to Rec. 709.
#pragma once

#include <array>
#include <optional>

namespace lambent::image {

/// CIE 1931 x and y.
struct Chromaticity {
    double x, y;
};

/// Chromaticities of the three primaries and of white, which all channels 1 make. The default is Rec. 709.
struct Primaries {
    Chromaticity red{0.64, 0.33}, green{0.30, 0.60}, blue{0.15, 0.06}, white{0.3127, 0.3290};
};

/// A matrix by rows, which multiplies the column (r, g, b).
using ColourMatrix = std::array<std::array<double, 3>, 3>;

/// The matrix from `primaries` to Rec. 709 with its white D65. The white is adapted by the Bradford transform [Lam
/// 1985, "Metamerism and colour constancy"], except for the primaries (1, 0), (0, 1), (0, 0), with which OpenEXR marks
/// CIE XYZ tristimulus values ("Technical Introduction to OpenEXR"). Returns nothing if the primaries form no triangle,
/// a value is not finite or the white has no luminance.
std::optional<ColourMatrix> to_rec709(const Primaries& primaries);

/// Whether every element of a matrix is within 1e-3 of the identity.
bool is_identity(const ColourMatrix& matrix);

} // namespace lambent::image
