#include "image/openexr/openexr_header.h"

#include "image/openexr/openexr_attributes.h"
#include "image/openexr/openexr_cursor.h"
#include "image/refuse.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace lambent::image {
namespace {

constexpr std::array<std::uint8_t, 4> magic = {0x76, 0x2f, 0x31, 0x01};

constexpr std::uint32_t flag_tiled = 0x200;
constexpr std::uint32_t flag_long_names = 0x400;
constexpr std::uint32_t flag_deep = 0x800;
constexpr std::uint32_t flag_multipart = 0x1000;

class HeaderScan {
public:
    HeaderScan(std::vector<std::uint8_t>& bytes, const ByteSource& source)
        : cursor_(bytes), source_(source), name_(source.name())
    {
    }

    // Positions of the type names of attributes that are not used.
    const std::vector<std::size_t>& unknown_types() const { return unknown_types_; }

    // Returns the length of all headers. Throws ExrCursor::NeedsMore if they extend beyond the bytes.
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
        found_.clear();
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
        if (type.empty() || size > source_.size())
            refuse(name_, "its attribute ", printable(name), " has ",
                   type.empty() ? "no type" : "a wrong size");
        const ExrAttribute* const known = find_exr_attribute(name);
        if (!known) {
            cursor_.take(size);
            unknown_types_.push_back(type_at);
            return;
        }
        const bool sound = type == known->type && (known->size == 0 || size == known->size);
        const bool optional = known->need == ExrAttribute::Need::optional;
        if (!sound && !optional)
            refuse(name_, "its attribute ", known->name, " has the wrong type or size");
        const std::span<std::uint8_t> value = cursor_.take(size);
        if (!optional) {
            found_.push_back(known);
            read_exr_attribute(*known, value, source_, part);
        } else if (!sound || !read_optional_exr_attribute(*known, value, part)) {
            part.warnings.push_back(text("its attribute ", known->name, " is invalid; it is ignored"));
            unknown_types_.push_back(type_at);
        }
    }

    void check_part(ExrPart& part) const
    {
        for (const ExrAttribute& attribute : exr_attributes())
            if (attribute.need == ExrAttribute::Need::required &&
                std::ranges::find(found_, &attribute) == found_.end())
                refuse(name_, "its attribute ", attribute.name, " is missing");
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
            part.warnings.push_back(text("its attribute envmap says cube map, but ", part.width, "x",
                                         part.height,
                                         " is not six square faces one below the other; it is ignored"));
        }
        check_exr_part(part, source_.size(), name_);
    }

    ExrCursor cursor_;
    const ByteSource& source_;
    const std::string& name_;
    std::uint32_t version_ = 0;
    std::vector<const ExrAttribute*> found_; // in the current part
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
        } catch (const ExrCursor::NeedsMore&) {
            if (header.bytes.size() == source.size())
                refuse(source.name(), "ends in the middle of its header, after ", source.size(), " bytes");
        }
    }
    refuse(source.name(), "its header does not end within ", longest, " bytes");
}

} // namespace lambent::image
