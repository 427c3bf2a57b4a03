// Chooses the channels of an OpenEXR file that are read.
#pragma once

#include "image/openexr/openexr_header.h"

#include <array>
#include <optional>
#include <string>

namespace lambent::image {

struct ExrChoice {
    int part = 0;
    /// The channels for red, green and blue; all the same for grey.
    std::array<std::string, 3> channels;
    bool luminance_chroma = false; ///< Y, RY and BY are read instead
};

/// The channels of the first part that has any of these: R, G, B; else those of the first layer that has all three;
/// else Y with RY and BY; else Y. Throws Error(bad_input) if no part has any, or only in an unsupported form.
ExrChoice choose_channels(const ExrHeader& header, const std::string& name);

/// The alpha channel that belongs to these channels, in place of each; empty if there is none that can be read.
std::optional<ExrChoice> choose_alpha(const ExrHeader& header, const ExrChoice& colour);

} // namespace lambent::image
