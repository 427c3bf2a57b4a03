#include "compare/pixel_font.h"

#include <array>
#include <cctype>
#include <cstdint>

namespace lambent::compare {
namespace {

constexpr std::string_view characters = "0123456789ABCDEFGHILMNOPRSTUVXY.,%-+=:";

// Rows from the top, the leftmost pixel is the highest of five bits.
constexpr std::array<std::array<std::uint8_t, glyph_height>, characters.size()> glyphs = {{
    {14, 17, 19, 21, 25, 17, 14}, // 0
    {4, 12, 4, 4, 4, 4, 14},      // 1
    {14, 17, 1, 2, 4, 8, 31},     // 2
    {31, 2, 4, 2, 1, 17, 14},     // 3
    {2, 6, 10, 18, 31, 2, 2},     // 4
    {31, 16, 30, 1, 1, 17, 14},   // 5
    {6, 8, 16, 30, 17, 17, 14},   // 6
    {31, 1, 2, 4, 8, 8, 8},       // 7
    {14, 17, 17, 14, 17, 17, 14}, // 8
    {14, 17, 17, 15, 1, 2, 12},   // 9
    {14, 17, 17, 31, 17, 17, 17}, // A
    {30, 17, 17, 30, 17, 17, 30}, // B
    {14, 17, 16, 16, 16, 17, 14}, // C
    {30, 17, 17, 17, 17, 17, 30}, // D
    {31, 16, 16, 30, 16, 16, 31}, // E
    {31, 16, 16, 30, 16, 16, 16}, // F
    {14, 17, 16, 23, 17, 17, 15}, // G
    {17, 17, 17, 31, 17, 17, 17}, // H
    {14, 4, 4, 4, 4, 4, 14},      // I
    {16, 16, 16, 16, 16, 16, 31}, // L
    {17, 27, 21, 21, 17, 17, 17}, // M
    {17, 25, 21, 19, 17, 17, 17}, // N
    {14, 17, 17, 17, 17, 17, 14}, // O
    {30, 17, 17, 30, 16, 16, 16}, // P
    {30, 17, 17, 30, 20, 18, 17}, // R
    {15, 16, 16, 14, 1, 1, 30},   // S
    {31, 4, 4, 4, 4, 4, 4},       // T
    {17, 17, 17, 17, 17, 17, 14}, // U
    {17, 17, 17, 17, 17, 10, 4},  // V
    {17, 17, 10, 4, 10, 17, 17},  // X
    {17, 17, 10, 4, 4, 4, 4},     // Y
    {0, 0, 0, 0, 0, 12, 12},      // .
    {0, 0, 0, 0, 12, 4, 8},       // ,
    {25, 26, 2, 4, 8, 11, 19},    // %
    {0, 0, 0, 31, 0, 0, 0},       // -
    {0, 4, 4, 31, 4, 4, 0},       // +
    {0, 0, 31, 0, 31, 0, 0},      // =
    {0, 12, 12, 0, 12, 12, 0},    // :
}};

void fill_square(image::CodeImage& image, int x, int y, int size)
{
    for (int row = y; row < y + size; ++row)
        for (int column = x; column < x + size; ++column)
            if (row >= 0 && row < image.height && column >= 0 && column < image.width) {
                const std::size_t pixel =
                    static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                    static_cast<std::size_t>(column);
                for (std::size_t c = 0; c < 3; ++c)
                    image.bytes[3 * pixel + c] = 255;
            }
}

} // namespace

int write_text(image::CodeImage& image, const TextPlace& place, std::string_view text)
{
    int x = place.x;
    for (const char c : text) {
        const std::size_t which =
            characters.find(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
        if (which != std::string_view::npos)
            for (int row = 0; row < glyph_height; ++row)
                for (int column = 0; column < glyph_width; ++column)
                    if (glyphs[which][static_cast<std::size_t>(row)] >> (glyph_width - 1 - column) & 1)
                        fill_square(image, x + column * place.scale, place.y + row * place.scale,
                                    place.scale);
        x += (glyph_width + 1) * place.scale;
    }
    return x;
}

int text_width(std::string_view text)
{
    return static_cast<int>(text.size()) * (glyph_width + 1);
}

} // namespace lambent::compare
