// Picture files read so that they can be compared.
#pragma once

#include "base/error.h"
#include "image/image.h"

#include <filesystem>

namespace lambent::compare {

/// What the numbers of a picture are.
enum class Kind {
    srgb,   ///< codes of a .png or .jpg divided by their largest, 0 to 1
    linear, ///< light of a .exr or .hdr
};

/// As in the command's output.
const char* name_of(Kind kind);

/// Two pictures of one size and kind, RGB without coverage, every value finite.
struct ImagePair {
    Kind kind = Kind::srgb;
    image::RadianceImage picture;
    image::RadianceImage reference;
};

/// Reads both. Sizes and kinds are compared before pixels are read. Values that are not finite become 0, with one
/// warning for each file that counts them: an error that only one picture has is seen, and one that both have is not
/// hidden by being added to everything. Alpha is left out. Throws Error(bad_input).
ImagePair read_image_pair(const std::filesystem::path& picture, const std::filesystem::path& reference,
                          Warnings& warnings);

/// Multiplies all values. Products stay finite.
void expose(image::RadianceImage& picture, float factor);

/// Cuts all values to [0, limit].
void clamp(image::RadianceImage& picture, float limit);

} // namespace lambent::compare
