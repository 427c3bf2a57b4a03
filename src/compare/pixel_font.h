// Letters of five by seven pixels, for legends.
#pragma once

#include "compare/color_map.h"
#include "image/image.h"

#include <string_view>

namespace lambent::compare {

/// Width of a letter with the gap behind it, and height, at scale 1.
inline constexpr int letter_pitch = 6, letter_height = 7;

/// Width of a line of text at a scale, without the last gap.
int text_width(std::string_view text, int scale);

struct TextPosition {
    int x, y;  ///< of the top left pixel
    int scale; ///< pixels for each pixel of the letter
};

/// Draws text into an 8-bit RGB image, clipped to it. The font has digits, capitals (also for small letters) and
/// " .-+%:"; any other character is an empty box.
void draw_text(image::CodeImage& image, std::string_view text, const TextPosition& position,
               const Code& color);

} // namespace lambent::compare
