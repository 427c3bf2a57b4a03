#include "tests/scene/png_writer.h"

#include "tests/image/png_writer.h"

namespace lambent::scene::test {

std::vector<std::uint8_t> make_png(const Pixels& pixels)
{
    lambent::test::Bytes rows;
    for (std::size_t i = 0; i < pixels.values.size(); ++i) {
        if (i % (4 * pixels.width) == 0)
            rows.push_back(0); // filter: none
        if (pixels.bits == 16)
            rows.push_back(static_cast<std::uint8_t>(pixels.values[i] >> 8));
        rows.push_back(static_cast<std::uint8_t>(pixels.values[i]));
    }
    constexpr std::uint8_t rgba = 6;
    return lambent::test::png_file(
        {pixels.width, pixels.height, static_cast<std::uint8_t>(pixels.bits), rgba}, rows);
}

} // namespace lambent::scene::test
