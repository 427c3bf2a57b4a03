#include "reference/texture.h"

#include "equations/in_double.h"

#include <glm/common.hpp>

#include <array>
#include <cmath>
#include <cstring>

namespace lambent::reference {
namespace {

double decoded(double code, view::TexelTransfer transfer)
{
    if (transfer == view::TexelTransfer::srgb)
        return in_double::srgb_decode(code);
    return transfer == view::TexelTransfer::power_2_2 ? in_double::power(code, 2.2) : code;
}

using CodeTable = std::array<double, 256>;

CodeTable code_table(view::TexelTransfer transfer)
{
    CodeTable table;
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = decoded(static_cast<double>(i) / 255.0, transfer);
    return table;
}

const CodeTable& code_light(view::TexelTransfer transfer)
{
    static const CodeTable tables[3] = {code_table(view::TexelTransfer::srgb),
                                        code_table(view::TexelTransfer::power_2_2),
                                        code_table(view::TexelTransfer::none)};
    return tables[static_cast<std::size_t>(transfer)];
}

int wrapped(std::int64_t i, int size, scene::Wrap wrap)
{
    if (wrap == scene::Wrap::clamp_to_edge)
        return static_cast<int>(std::clamp<std::int64_t>(i, 0, size - 1));
    const std::int64_t period = wrap == scene::Wrap::repeat ? size : 2 * std::int64_t{size};
    const std::int64_t within = ((i % period) + period) % period;
    return static_cast<int>(within < size ? within : period - 1 - within);
}

glm::dvec4 texel(const image::CodeImage& image, int x, int y, view::TexelTransfer transfer)
{
    const std::size_t first = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                   static_cast<std::size_t>(x));
    glm::dvec4 rgba;
    for (int c = 0; c < 4; ++c) {
        const view::TexelTransfer by = c == 3 ? view::TexelTransfer::none : transfer;
        const std::size_t at = first + static_cast<std::size_t>(c);
        if (image.bits == 8) {
            rgba[c] = code_light(by)[image.bytes[at]];
            continue;
        }
        std::uint16_t code = 0;
        std::memcpy(&code, image.bytes.data() + 2 * at, 2);
        rgba[c] = decoded(code / 65535.0, by);
    }
    return rgba;
}

} // namespace

glm::dvec4 read_texture(const image::CodeImage& image, const scene::Sampler& sampler,
                        view::TexelTransfer transfer, const glm::dvec2& uv)
{
    // Limits coordinates so that texel indices fit 64-bit integers.
    const double x = std::clamp(uv.x * image.width, -1e15, 1e15) - 0.5;
    const double y = std::clamp(uv.y * image.height, -1e15, 1e15) - 0.5;
    const double left = sampler.magnify_nearest ? std::floor(x + 0.5) : std::floor(x);
    const double top = sampler.magnify_nearest ? std::floor(y + 0.5) : std::floor(y);
    const auto at = [&](int dx, int dy) {
        return texel(image, wrapped(static_cast<std::int64_t>(left) + dx, image.width, sampler.wrap_u),
                     wrapped(static_cast<std::int64_t>(top) + dy, image.height, sampler.wrap_v), transfer);
    };
    if (sampler.magnify_nearest)
        return at(0, 0);
    const double right = x - left, below = y - top;
    return glm::mix(glm::mix(at(0, 0), at(1, 0), right), glm::mix(at(0, 1), at(1, 1), right), below);
}

} // namespace lambent::reference
