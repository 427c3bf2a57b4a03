#include "image/openexr/openexr_header.h"

#include "image/refuse.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <iterator>
#include <string_view>

namespace lambent::image {
namespace {

constexpr std::array<std::uint8_t, 4> magic = {0x76, 0x2f, 0x31, 0x01};

constexpr std::uint32_t flag_tiled = 0x200;
constexpr std::uint32_t flag_long_names = 0x400;
constexpr std::uint32_t flag_deep = 0x800;
constexpr std::uint32_t flag_multipart = 0x1000;

// The attributes that this program or the library uses. Size 0 means any size.
struct Attribute {
    std::string_view name;
    std::string_view type;
    std::uint32_t size;
};
constexpr Attribute known_attributes[] = {{"channels", "chlist", 0},
                                          {"compression", "compression", 1},
                                          {"dataWindow", "box2i", 16},
                                          {"displayWindow", "box2i", 16},
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
                                          {"chromaticities", "chromaticities", 32},
                                          {"envmap", "envmap", 1}};
// Known attributes that are ignored if their values are invalid.
constexpr std::string_view optional_attributes[] = {"chromaticities", "envmap"};

// Thrown when the header extends beyond the bytes read so far.
struct NeedsMore {};

std::uint32_t little_endian(const std::uint8_t* bytes)
{
    return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
           std::uint32_t{bytes[3]} << 24;
}

std::int32_t signed_at(const std::uint8_t* bytes)
{
    return static_cast<std::int32_t>(little_endian(bytes));
}

// Reads consecutive values from a span.
class Cursor {
public:
    explicit Cursor(std::span<std::uint8_t> bytes) : bytes_(bytes) {}

    std::size_t at() const { return at_; }

    std::span<std::uint8_t> take(std::size_t count)
    {
        if (count > bytes_.size() - at_)
            throw NeedsMore();
        at_ += count;
        return bytes_.subspan(at_ - count, count);
    }

    std::uint32_t take_word() { return little_endian(take(4).data()); }

    // Takes a zero-terminated name.
    std::string_view take_name()
    {
        const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(at_);
        const auto end = std::find(begin, bytes_.end(), std::uint8_t{0});
        if (end == bytes_.end())
            throw NeedsMore();
        const auto length = static_cast<std::size_t>(end - begin);
        const std::span<std::uint8_t> name = take(length + 1);
        return {reinterpret_cast<const char*>(name.data()), length};
    }

private:
    std::span<std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

class HeaderScan {
public:
    HeaderScan(std::vector<std::uint8_t>& bytes, const ByteSource& source)
        : cursor_(bytes), name_(source.name()), file_size_(source.size())
    {
    }

    // Positions of the type names of attributes that are not used.
    const std::vector<std::size_t>& unknown_types() const { return unknown_types_; }

    // Returns the length of all headers.
    std::size_t scan(std::vector<ExrPart>& parts)
    {
        if (!std::ranges::equal(cursor_.take(4), magic))
            refuse(name_, "not an OpenEXR file");
        version_ = cursor_.take_word();
        if ((version_ & 0xff) != 2 ||
            (version_ & ~(0xffu | flag_tiled | flag_long_names | flag_deep | flag_multipart)) != 0)
            refuse(name_, "its OpenEXR version ", version_, " is not known");
        constexpr std::size_t max_parts = 1024;
        ExrPart part;
        while (scan_part(part)) {
            check_part(part);
            parts.push_back(std::move(part));
            part = {};
            if (!(version_ & flag_multipart))
                break;
            if (parts.size() == max_parts)
                refuse(name_, "has more than ", max_parts, " parts");
        }
        if (parts.empty())
            refuse(name_, "has no image");
        return cursor_.at();
    }

private:
    // Reads attributes up to the empty name that ends the header of a part. Returns false if there are none.
    bool scan_part(ExrPart& part)
    {
        found_.fill(false);
        bool any = false;
        for (std::string_view name = cursor_.take_name(); !name.empty(); name = cursor_.take_name()) {
            scan_attribute(name, part);
            any = true;
        }
        return any;
    }

    void scan_attribute(std::string_view name, ExrPart& part)
    {
        const std::string_view type = cursor_.take_name();
        const std::size_t type_at = cursor_.at() - type.size() - 1;
        const std::uint32_t size = cursor_.take_word();
        if (type.empty() || size > file_size_)
            refuse(name_, "its attribute ", printable(name), " has ",
                   type.empty() ? "no type" : "a wrong size");
        const auto known = std::ranges::find(known_attributes, name, &Attribute::name);
        if (known == std::end(known_attributes)) {
            cursor_.take(size);
            unknown_types_.push_back(type_at);
            return;
        }
        const bool sound = type == known->type && (known->size == 0 || size == known->size);
        const bool optional = std::ranges::count(optional_attributes, name) > 0;
        if (!sound && !optional)
            refuse(name_, "its attribute ", known->name, " has the wrong type or size");
        const std::span<std::uint8_t> value = cursor_.take(size);
        if (optional && !(sound && read_optional(name, value, part))) {
            part.doubts.push_back(text("its attribute ", known->name, " makes no sense; it is ignored"));
            unknown_types_.push_back(type_at);
            return;
        }
        found_[static_cast<std::size_t>(known - std::begin(known_attributes))] = true;
        if (!optional)
            read_attribute(name, value, part);
    }

    // Returns false for invalid values.
    static bool read_optional(std::string_view name, std::span<const std::uint8_t> value, ExrPart& part)
    {
        if (name == "envmap") {
            if (value[0] > 1)
                return false;
            part.projection = value[0] == 1 ? Projection::cube : Projection::latitude_longitude;
            return true;
        }
        double c[8];
        for (std::size_t i = 0; i < 8; ++i)
            c[i] = std::bit_cast<float>(little_endian(value.data() + 4 * i));
        part.primaries = {{c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]}, {c[6], c[7]}};
        if (to_rec709(*part.primaries))
            return true;
        part.primaries.reset();
        return false;
    }

    void read_attribute(std::string_view name, std::span<std::uint8_t> value, ExrPart& part)
    {
        if (name == "channels")
            read_channels(value, part);
        else if (name == "compression")
            part.compression = value[0];
        else if (name == "dataWindow")
            set_data_window(read_window(value, "data"), part);
        else if (name == "displayWindow")
            part.display = read_window(value, "display");
        else if (name == "tiles")
            read_tiles(value, part);
        else if (name == "type")
            part.type.assign(value.begin(), value.end());
        else if (name == "chunkCount" && little_endian(value.data()) > file_size_ / 8)
            refuse(name_, "its chunkCount of ", signed_at(value.data()), " does not fit into ", file_size_,
                   " bytes");
    }

    void read_channels(std::span<std::uint8_t> value, ExrPart& part)
    try {
        constexpr std::size_t max_channels = 1024;
        Cursor cursor(value);
        part.channels.clear();
        for (std::string_view name = cursor.take_name(); !name.empty(); name = cursor.take_name()) {
            const std::uint32_t pixel = cursor.take_word();
            cursor.take(4); // perceptual linearity and padding
            const auto x = static_cast<std::int32_t>(cursor.take_word());
            const auto y = static_cast<std::int32_t>(cursor.take_word());
            if (pixel > 2 || x < 1 || y < 1 || part.channels.size() == max_channels)
                refuse(name_, "its channel ", printable(name), " makes no sense");
            part.channels.push_back({std::string(name), static_cast<ExrPixel>(pixel), x, y});
        }
    } catch (const NeedsMore&) {
        refuse(name_, "its list of channels goes beyond its end");
    }

    ExrWindow read_window(std::span<std::uint8_t> value, const char* which) const
    {
        const std::int64_t min_x = signed_at(value.data()), min_y = signed_at(value.data() + 4);
        const std::int64_t max_x = signed_at(value.data() + 8), max_y = signed_at(value.data() + 12);
        check_size(name_, max_x - min_x + 1, max_y - min_y + 1);
        constexpr std::int64_t far = std::int64_t{1} << 28;
        if (min_x < -far || min_y < -far || max_x > far || max_y > far)
            refuse(name_, "its ", which, " window starts at ", min_x, ",", min_y, ", which is too far away");
        return {static_cast<int>(min_x), static_cast<int>(min_y), static_cast<int>(max_x - min_x + 1),
                static_cast<int>(max_y - min_y + 1)};
    }

    static void set_data_window(const ExrWindow& window, ExrPart& part)
    {
        part.min_x = window.min_x;
        part.min_y = window.min_y;
        part.width = window.width;
        part.height = window.height;
    }

    void read_tiles(std::span<std::uint8_t> value, ExrPart& part)
    {
        const std::uint32_t width = little_endian(value.data()), height = little_endian(value.data() + 4);
        check_size(name_, width, height);
        part.tile_width = static_cast<int>(width);
        part.tile_height = static_cast<int>(height);
    }

    void check_part(ExrPart& part) const
    {
        for (const std::size_t needed : {0u, 1u, 2u, 3u})
            if (!found_[needed])
                refuse(name_, "its attribute ", known_attributes[needed].name, " is missing");
        if (part.compression >= exr_compressions)
            refuse(name_, "its compression ", part.compression, " is not known");
        const bool multipart = (version_ & flag_multipart) != 0;
        part.deep = (version_ & flag_deep) != 0 && part.type != "scanlineimage" && part.type != "tiledimage";
        part.tiled =
            multipart ? part.type == "tiledimage" || part.type == "deeptile" : (version_ & flag_tiled) != 0;
        if (part.tiled && part.tile_width == 0)
            refuse(name_, "its tiles have no size");
        if (part.projection == Projection::cube &&
            std::int64_t{part.height} != 6 * std::int64_t{part.width}) {
            part.projection = Projection::unknown;
            part.doubts.push_back(text("its attribute envmap says cube map, but ", part.width, "x",
                                       part.height, " is not six faces one below the other; it is ignored"));
        }
        check_exr_part(part, file_size_, name_);
    }

    Cursor cursor_;
    const std::string& name_;
    std::uint64_t file_size_;
    std::uint32_t version_ = 0;
    std::array<bool, std::size(known_attributes)> found_{};
    std::vector<std::size_t> unknown_types_;
};

} // namespace

bool is_exr(std::span<const std::uint8_t> bytes)
{
    return bytes.size() >= magic.size() && std::ranges::equal(bytes.first(magic.size()), magic);
}

ExrHeader read_exr_header(ByteSource& source)
{
    constexpr std::uint64_t usual = std::uint64_t{1} << 16, longest = std::uint64_t{1} << 24;
    for (const std::uint64_t limit : {usual, longest}) {
        ExrHeader header;
        header.bytes.resize(static_cast<std::size_t>(std::min(limit, source.size())));
        source.read(0, header.bytes.data(), header.bytes.size());
        HeaderScan scan(header.bytes, source);
        try {
            header.bytes.resize(scan.scan(header.parts));
            for (const std::size_t at : scan.unknown_types())
                header.bytes[at] = '?';
            return header;
        } catch (const NeedsMore&) {
            if (header.bytes.size() == source.size())
                refuse(source.name(), "ends in the middle of its header, after ", source.size(), " bytes");
        }
    }
    refuse(source.name(), "its header does not end within ", longest, " bytes");
}

} // namespace lambent::image
