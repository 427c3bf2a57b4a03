// Which channels of an OpenEXR file are its picture.
#pragma once

#include "image/openexr/openexr_header.h"

#include <array>
#include <string>

namespace lambent::image {

struct ExrChoice {
    int part = 0;
    /// The channels that make red, green and blue; all three the same for grey.
    std::array<std::string, 3> channels;
    bool luminance_chroma = false; ///< Y, RY and BY instead
};

/// Of the first part that has any: R, G, B; else those of the first layer that has all three; else Y with RY and BY; else Y.
/// Throws Error(bad_input) where there is nothing of that, or in a form that is not read.
ExrChoice choose_channels(const ExrHeader& header, const std::string& name);

} // namespace lambent::image
