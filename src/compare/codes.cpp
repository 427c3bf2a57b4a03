#include "compare/codes.h"

#include "equations/in_double.h"

#include <tbb/parallel_for.h>

#include <cstring>

namespace lambent::compare {

image::RadianceImage code_values(const image::CodeImage& codes)
{
    image::RadianceImage image{codes.width, codes.height, 3, {}};
    const std::size_t pixels = static_cast<std::size_t>(codes.width) * static_cast<std::size_t>(codes.height);
    const auto channels = static_cast<std::size_t>(codes.channels);
    image.values.reserve(3 * pixels);
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t at = channels * i + c;
            std::uint16_t wide = 0;
            if (codes.bits == 16)
                std::memcpy(&wide, codes.bytes.data() + 2 * at, 2);
            image.values.push_back(codes.bits == 16 ? static_cast<float>(wide) / 65535.0f
                                                    : static_cast<float>(codes.bytes[at]) / 255.0f);
        }
    return image;
}

image::RadianceImage light_of_codes(const image::RadianceImage& codes)
{
    image::RadianceImage light = codes;
    tbb::parallel_for(0, light.height, [&](int y) {
        for (int i = 0; i < light.width * light.channels; ++i)
            light.pixel(0, y)[i] =
                static_cast<float>(in_double::srgb_decode(static_cast<double>(light.pixel(0, y)[i])));
    });
    return light;
}

} // namespace lambent::compare
