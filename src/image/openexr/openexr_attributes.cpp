#include "image/openexr/openexr_attributes.h"

#include "image/openexr/openexr_cursor.h"
#include "image/refuse.h"

#include <algorithm>
#include <bit>
#include <iterator>

namespace lambent::image {
namespace {

using Need = ExrAttribute::Need;

constexpr ExrAttribute used_attributes[] = {
    {"channels", "chlist", 0, Need::required},
    {"compression", "compression", 1, Need::required},
    {"dataWindow", "box2i", 16, Need::required},
    {"displayWindow", "box2i", 16, Need::required},
    {"lineOrder", "lineOrder", 1},
    {"pixelAspectRatio", "float", 4},
    {"screenWindowCenter", "v2f", 8},
    {"screenWindowWidth", "float", 4},
    {"tiles", "tiledesc", 9},
    {"type", "string", 0},
    {"name", "string", 0},
    {"chunkCount", "int", 4},
    {"version", "int", 4},
    {"view", "string", 0},
    {"chromaticities", "chromaticities", 32, Need::optional},
    {"envmap", "envmap", 1, Need::optional},
};

void read_channels(std::span<std::uint8_t> value, const std::string& name, ExrPart& part)
try {
    constexpr std::size_t max_channels = 1024;
    ExrCursor cursor(value);
    part.channels.clear();
    for (std::string_view channel = cursor.take_name(); !channel.empty(); channel = cursor.take_name()) {
        const std::uint32_t pixel = cursor.take_word();
        cursor.take(4); // perceptual linearity and padding
        const auto x = static_cast<std::int32_t>(cursor.take_word());
        const auto y = static_cast<std::int32_t>(cursor.take_word());
        if (pixel > 2 || x < 1 || y < 1 || part.channels.size() == max_channels)
            refuse(name, "its channel ", printable(channel), " is invalid");
        part.channels.push_back({std::string(channel), static_cast<ExrPixel>(pixel), x, y});
    }
} catch (const ExrCursor::NeedsMore&) {
    refuse(name, "its list of channels extends beyond its attribute");
}

ExrWindow read_window(std::span<const std::uint8_t> value, const std::string& name, const char* which)
{
    const std::int64_t min_x = signed_little_endian(value.data()),
                       min_y = signed_little_endian(value.data() + 4);
    const std::int64_t max_x = signed_little_endian(value.data() + 8),
                       max_y = signed_little_endian(value.data() + 12);
    check_size(name, max_x - min_x + 1, max_y - min_y + 1);
    constexpr std::int64_t far = std::int64_t{1} << 28;
    if (min_x < -far || min_y < -far || max_x > far || max_y > far)
        refuse(name, "its ", which, " window starts at ", min_x, ",", min_y,
               ", which is too far from the origin");
    return {static_cast<int>(min_x), static_cast<int>(min_y), static_cast<int>(max_x - min_x + 1),
            static_cast<int>(max_y - min_y + 1)};
}

void set_data_window(const ExrWindow& window, ExrPart& part)
{
    part.min_x = window.min_x;
    part.min_y = window.min_y;
    part.width = window.width;
    part.height = window.height;
}

void read_tiles(std::span<const std::uint8_t> value, const std::string& name, ExrPart& part)
{
    const std::uint32_t width = little_endian(value.data()), height = little_endian(value.data() + 4);
    check_size(name, width, height);
    part.tile_width = static_cast<int>(width);
    part.tile_height = static_cast<int>(height);
}

bool read_projection(std::span<const std::uint8_t> value, ExrPart& part)
{
    if (value[0] > 1)
        return false;
    part.projection = value[0] == 1 ? Projection::cube : Projection::latitude_longitude;
    return true;
}

bool read_primaries(std::span<const std::uint8_t> value, ExrPart& part)
{
    double c[8];
    for (std::size_t i = 0; i < 8; ++i)
        c[i] = std::bit_cast<float>(little_endian(value.data() + 4 * i));
    const Primaries primaries = {{c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]}, {c[6], c[7]}};
    if (!to_rec709(primaries))
        return false;
    part.primaries = primaries;
    return true;
}

} // namespace

std::span<const ExrAttribute> exr_attributes()
{
    return used_attributes;
}

const ExrAttribute* find_exr_attribute(std::string_view name)
{
    const auto* const found = std::ranges::find(used_attributes, name, &ExrAttribute::name);
    return found == std::end(used_attributes) ? nullptr : found;
}

void read_exr_attribute(const ExrAttribute& attribute, std::span<std::uint8_t> value,
                        const ByteSource& source, ExrPart& part)
{
    const std::string& name = source.name();
    if (attribute.name == "channels")
        read_channels(value, name, part);
    else if (attribute.name == "compression")
        part.compression = value[0];
    else if (attribute.name == "dataWindow")
        set_data_window(read_window(value, name, "data"), part);
    else if (attribute.name == "displayWindow")
        part.display = read_window(value, name, "display");
    else if (attribute.name == "tiles")
        read_tiles(value, name, part);
    else if (attribute.name == "type")
        part.type.assign(value.begin(), value.end());
    else if (attribute.name == "chunkCount" && little_endian(value.data()) > source.size() / 8)
        refuse(name, "its chunkCount of ", signed_little_endian(value.data()), " does not fit into ",
               source.size(), " bytes");
}

bool read_optional_exr_attribute(const ExrAttribute& attribute, std::span<const std::uint8_t> value,
                                 ExrPart& part)
{
    return attribute.name == "envmap" ? read_projection(value, part) : read_primaries(value, part);
}

} // namespace lambent::image
