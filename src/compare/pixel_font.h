// Capital letters, figures and a few signs, five by seven pixels, for legends.
#pragma once

#include "image/image.h"

#include <string_view>

namespace lambent::compare {

constexpr int glyph_width = 5, glyph_height = 7;

/// White text into an RGB picture, its upper left corner at (x, y), each of the font's pixels `scale` wide; what does not
/// fit is left out. Small letters are written as capitals, unknown characters as gaps. Returns where the text ends.
struct TextPlace {
    int x, y, scale;
};
int write_text(image::CodeImage& image, const TextPlace& place, std::string_view text);

/// Width of a text at scale 1.
int text_width(std::string_view text);

} // namespace lambent::compare
