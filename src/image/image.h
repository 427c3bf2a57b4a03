// Images in memory: linear radiance and code values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent::image {

/// Linear RGB or RGBA with Rec. 709 primaries, proportional to radiance (one unit of an environment is one nit
/// unless its author says otherwise). Rows from the top, pixels from the left, channels interleaved.
struct RadianceImage {
    int width = 0;
    int height = 0;
    int channels = 3;          ///< 3 (RGB) or 4 (RGB premultiplied by coverage, then coverage)
    std::vector<float> values; ///< width * height * channels

    /// In a rendered image, the part of `values` that comes from unlit surfaces, whose colour is displayed without
    /// exposure and tone curve: RGBA, premultiplied by A, the fraction of the pixel that they cover. Empty if there are
    /// none.
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

/// An image whose values are all 0.
inline RadianceImage black_image(int width, int height, int channels = 3)
{
    RadianceImage image{width, height, channels, {}};
    image.values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                        static_cast<std::size_t>(channels));
    return image;
}

/// Code values of a PNG, a JPEG, a display or a texture, in the order of RadianceImage. Their transfer function
/// is known to the caller and not stored here.
struct CodeImage {
    int width = 0;
    int height = 0;
    int channels = 3; ///< 3 (RGB) or 4 (RGBA, not premultiplied)
    int bits = 8;     ///< 8 or 16
    std::vector<std::uint8_t>
        bytes; ///< width * height * channels * bits / 8; 16-bit codes in the machine's byte order
};

} // namespace lambent::image
