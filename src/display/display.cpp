#include "display/display.h"

#include "display/display_kernel.h"

#include <tbb/parallel_for.h>

namespace lambent::display {

image::CodeImage to_codes(const image::RadianceImage& light, const Settings& settings)
{
    image::CodeImage codes{light.width, light.height, 3, 8, {}};
    const std::size_t pitch = static_cast<std::size_t>(light.width) * 3;
    codes.bytes.resize(pitch * static_cast<std::size_t>(light.height));
    tbb::parallel_for(0, light.height, [&](int y) {
        const float* const unlit = light.unlit.empty()
                                       ? nullptr
                                       : light.unlit.data() + 4 * static_cast<std::size_t>(y) *
                                                                  static_cast<std::size_t>(light.width);
        display_row({light.pixel(0, y), light.channels, light.width, y, unlit}, settings,
                    codes.bytes.data() + static_cast<std::size_t>(y) * pitch);
    });
    return codes;
}

} // namespace lambent::display
