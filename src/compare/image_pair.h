// Two image files read for a comparison.
#pragma once

#include "base/error.h"
#include "image/image.h"

#include <filesystem>
#include <vector>

namespace lambent::compare {

/// What the values of an image are.
enum class Kind {
    srgb,   ///< codes of a .png or .jpg divided by their largest, 0 to 1
    linear, ///< light of a .exr or .hdr
};

/// The name of a kind in the command's output.
const char* name_of(Kind kind);

/// Two images of one size and kind, RGB without coverage, every value finite.
struct ImagePair {
    Kind kind = Kind::srgb;
    image::RadianceImage picture;
    image::RadianceImage reference;
    std::vector<char> covered; ///< of each pixel, whether it is compared; empty: all
};

/// Reads both. Sizes and kinds are compared before pixels are read. Values that are not finite become 0, with one
/// warning for each file that counts them: a value broken in one image only shows as an error, and one broken in both
/// does not spoil the other results. Alpha is left out. Throws Error(bad_input).
ImagePair read_image_pair(const std::filesystem::path& picture, const std::filesystem::path& reference,
                          Warnings& warnings);

/// Restricts a comparison to the pixels that a surface covers, in part at least, in one of the two images. Throws
/// Error(bad_input) if an image has no coverage (image::read_coverage), or none of its pixels is covered.
void keep_covered(const std::filesystem::path& picture, const std::filesystem::path& reference,
                  ImagePair& pictures);

/// Multiplies all values. Products stay finite.
void expose(image::RadianceImage& picture, float factor);

/// Clamps all values to [0, limit].
void clamp(image::RadianceImage& picture, float limit);

} // namespace lambent::compare
