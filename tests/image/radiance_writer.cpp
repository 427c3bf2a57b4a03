#include "tests/image/radiance_writer.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace lambent::test {

Bytes flat_scanline(const Pixels& pixels)
{
    Bytes bytes;
    for (const Pixel& pixel : pixels)
        bytes.insert(bytes.end(), pixel.begin(), pixel.end());
    return bytes;
}

Bytes repeat_scanline(const Pixels& pixels)
{
    Bytes bytes;
    for (std::size_t i = 0; i < pixels.size();) {
        bytes.insert(bytes.end(), pixels[i].begin(), pixels[i].end());
        std::size_t end = i + 1;
        while (end < pixels.size() && pixels[end] == pixels[i])
            ++end;
        // The low byte of the count first, each further one in a marker of its own.
        for (std::size_t left = end - i - 1; left > 0; left >>= 8)
            for (const std::size_t byte : {std::size_t{1}, std::size_t{1}, std::size_t{1}, left & 255})
                bytes.push_back(static_cast<std::uint8_t>(byte));
        i = end;
    }
    return bytes;
}

Bytes plane_scanline(const Pixels& pixels)
{
    const std::size_t length = pixels.size();
    Bytes bytes = {2, 2, static_cast<std::uint8_t>(length / 256), static_cast<std::uint8_t>(length % 256)};
    for (std::size_t channel = 0; channel < 4; ++channel)
        for (std::size_t i = 0; i < length;) {
            std::size_t same = 1;
            while (i + same < length && same < 127 && pixels[i + same][channel] == pixels[i][channel])
                ++same;
            if (same > 2) {
                bytes.push_back(static_cast<std::uint8_t>(128 + same));
                bytes.push_back(pixels[i][channel]);
                i += same;
                continue;
            }
            // Literals of changing lengths, up to the longest.
            const std::size_t count = std::min({length - i, std::size_t{128}, 1 + i % 200});
            bytes.push_back(static_cast<std::uint8_t>(count));
            for (const std::size_t end = i + count; i < end; ++i)
                bytes.push_back(pixels[i][channel]);
        }
    return bytes;
}

Bytes radiance_header(const std::string& resolution, const std::string& lines)
{
    return bytes_of("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + lines + "\n" + resolution + "\n");
}

std::array<float, 3> radiance_of(const Pixel& pixel)
{
    std::array<float, 3> rgb{};
    for (std::size_t c = 0; c < 3; ++c)
        rgb[c] =
            pixel[3] == 0 ? 0.0f : static_cast<float>(std::ldexp(double{1} * pixel[c], pixel[3] - 128 - 8));
    return rgb;
}

Pixels mixed_pixels(std::size_t count, unsigned seed)
{
    std::minstd_rand random(seed);
    const auto byte = [&] { return static_cast<std::uint8_t>(random() >> 8); };
    Pixels pixels;
    while (pixels.size() < count) {
        Pixel pixel = {byte(), static_cast<std::uint8_t>(byte() | 128), byte(),
                       static_cast<std::uint8_t>(120 + byte() % 16)};
        if (random() % 16 == 0)
            pixel = {0, 0, 0, 0};
        const std::size_t repeats = random() % 4 == 0 ? 1 + random() % 400 : 1;
        pixels.insert(pixels.end(), std::min(repeats, count - pixels.size()), pixel);
    }
    return pixels;
}

} // namespace lambent::test
