#include "compare/pixel_font.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

namespace lambent::compare {
namespace {

struct Letter {
    char character;
    std::array<const char*, letter_height> rows;
};

constexpr Letter letters[] = {
    // clang-format off
    {'0', {".###.", "#...#", "#..##", "#.#.#", "##..#", "#...#", ".###."}},
    {'1', {"..#..", ".##..", "..#..", "..#..", "..#..", "..#..", ".###."}},
    {'2', {".###.", "#...#", "....#", "..##.", ".#...", "#....", "#####"}},
    {'3', {".###.", "#...#", "....#", "..##.", "....#", "#...#", ".###."}},
    {'4', {"...#.", "..##.", ".#.#.", "#..#.", "#####", "...#.", "...#."}},
    {'5', {"#####", "#....", "####.", "....#", "....#", "#...#", ".###."}},
    {'6', {"..##.", ".#...", "#....", "####.", "#...#", "#...#", ".###."}},
    {'7', {"#####", "....#", "...#.", "...#.", "..#..", "..#..", "..#.."}},
    {'8', {".###.", "#...#", "#...#", ".###.", "#...#", "#...#", ".###."}},
    {'9', {".###.", "#...#", "#...#", ".####", "....#", "...#.", ".##.."}},
    {'A', {".###.", "#...#", "#...#", "#####", "#...#", "#...#", "#...#"}},
    {'B', {"####.", "#...#", "#...#", "####.", "#...#", "#...#", "####."}},
    {'C', {".###.", "#...#", "#....", "#....", "#....", "#...#", ".###."}},
    {'D', {"####.", "#...#", "#...#", "#...#", "#...#", "#...#", "####."}},
    {'E', {"#####", "#....", "#....", "####.", "#....", "#....", "#####"}},
    {'F', {"#####", "#....", "#....", "####.", "#....", "#....", "#...."}},
    {'G', {".###.", "#...#", "#....", "#.###", "#...#", "#...#", ".###."}},
    {'H', {"#...#", "#...#", "#...#", "#####", "#...#", "#...#", "#...#"}},
    {'I', {".###.", "..#..", "..#..", "..#..", "..#..", "..#..", ".###."}},
    {'J', {"..###", "...#.", "...#.", "...#.", "...#.", "#..#.", ".##.."}},
    {'K', {"#...#", "#..#.", "#.#..", "##...", "#.#..", "#..#.", "#...#"}},
    {'L', {"#....", "#....", "#....", "#....", "#....", "#....", "#####"}},
    {'M', {"#...#", "##.##", "#.#.#", "#.#.#", "#...#", "#...#", "#...#"}},
    {'N', {"#...#", "##..#", "##..#", "#.#.#", "#..##", "#..##", "#...#"}},
    {'O', {".###.", "#...#", "#...#", "#...#", "#...#", "#...#", ".###."}},
    {'P', {"####.", "#...#", "#...#", "####.", "#....", "#....", "#...."}},
    {'Q', {".###.", "#...#", "#...#", "#...#", "#.#.#", "#..#.", ".##.#"}},
    {'R', {"####.", "#...#", "#...#", "####.", "#.#..", "#..#.", "#...#"}},
    {'S', {".####", "#....", "#....", ".###.", "....#", "....#", "####."}},
    {'T', {"#####", "..#..", "..#..", "..#..", "..#..", "..#..", "..#.."}},
    {'U', {"#...#", "#...#", "#...#", "#...#", "#...#", "#...#", ".###."}},
    {'V', {"#...#", "#...#", "#...#", "#...#", ".#.#.", ".#.#.", "..#.."}},
    {'W', {"#...#", "#...#", "#...#", "#.#.#", "#.#.#", "##.##", "#...#"}},
    {'X', {"#...#", "#...#", ".#.#.", "..#..", ".#.#.", "#...#", "#...#"}},
    {'Y', {"#...#", "#...#", ".#.#.", "..#..", "..#..", "..#..", "..#.."}},
    {'Z', {"#####", "....#", "...#.", "..#..", ".#...", "#....", "#####"}},
    {' ', {".....", ".....", ".....", ".....", ".....", ".....", "....."}},
    {'.', {".....", ".....", ".....", ".....", ".....", ".##..", ".##.."}},
    {'-', {".....", ".....", ".....", ".###.", ".....", ".....", "....."}},
    {'+', {".....", "..#..", "..#..", "#####", "..#..", "..#..", "....."}},
    {'%', {"##..#", "##..#", "...#.", "..#..", ".#...", "#..##", "#..##"}},
    {':', {".....", ".##..", ".##..", ".....", ".##..", ".##..", "....."}},
    // clang-format on
};

constexpr Letter unknown = {'\0', {"#####", "#...#", "#...#", "#...#", "#...#", "#...#", "#####"}};

const Letter& letter_of(char character)
{
    const auto capital = static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
    const Letter* found =
        std::find_if(std::begin(letters), std::end(letters),
                     [capital](const Letter& letter) { return letter.character == capital; });
    return found == std::end(letters) ? unknown : *found;
}

// Fills the square of one pixel of a letter.
void fill(image::CodeImage& image, const TextPosition& position, const Code& color)
{
    for (int y = std::max(position.y, 0); y < std::min(position.y + position.scale, image.height); ++y)
        for (int x = std::max(position.x, 0); x < std::min(position.x + position.scale, image.width); ++x) {
            const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                      static_cast<std::size_t>(x);
            std::copy(color.begin(), color.end(),
                      image.bytes.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
        }
}

} // namespace

int text_width(std::string_view text, int scale)
{
    return text.empty() ? 0 : (static_cast<int>(text.size()) * letter_pitch - 1) * scale;
}

void draw_text(image::CodeImage& image, std::string_view text, const TextPosition& position,
               const Code& color)
{
    int left = position.x;
    for (const char character : text) {
        const Letter& letter = letter_of(character);
        for (int y = 0; y < letter_height; ++y)
            for (int x = 0; x < letter_pitch - 1; ++x)
                if (letter.rows[static_cast<std::size_t>(y)][x] == '#')
                    fill(image, {left + x * position.scale, position.y + y * position.scale, position.scale},
                         color);
        left += letter_pitch * position.scale;
    }
}

} // namespace lambent::compare
