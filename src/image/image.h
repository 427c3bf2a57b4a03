// Pixels in memory, and what their numbers mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent::image {

/// Light: linear RGB or RGBA, proportional to radiance (one unit of an environment is one nit unless its
/// maker says otherwise), Rec. 709 primaries. Rows from the top, pixels from the left, channels interleaved.
struct RadianceImage {
    int width = 0;
    int height = 0;
    int channels = 3;          ///< 3 (RGB) or 4 (RGB and coverage; RGB is what arrives, multiplied by it)
    std::vector<float> values; ///< width * height * channels

    /// Of a drawn picture, RGBA: what of `values` comes from surfaces without lighting, which are shown in their own colour
    /// whatever exposure and tone curve are; and their share of the pixel, by which that is multiplied. Empty: none.
    std::vector<float> unlit = {};

    float* pixel(int x, int y) { return values.data() + offset(x, y); }
    const float* pixel(int x, int y) const { return values.data() + offset(x, y); }

private:
    std::size_t offset(int x, int y) const
    {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels);
    }
};

/// A picture in which everything is 0.
inline RadianceImage black_image(int width, int height, int channels = 3)
{
    RadianceImage image{width, height, channels, {}};
    image.values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                        static_cast<std::size_t>(channels));
    return image;
}

/// Code values: what a PNG or a JPEG holds and a display shows, or what a texture stores. Which transfer
/// function they went through is known by whoever uses them, not here. Same order as RadianceImage.
struct CodeImage {
    int width = 0;
    int height = 0;
    int channels = 3; ///< 3 (RGB) or 4 (RGBA, not premultiplied)
    int bits = 8;     ///< 8 or 16
    std::vector<std::uint8_t>
        bytes; ///< width * height * channels * bits / 8; 16-bit codes in the machine's byte order
};

} // namespace lambent::image
