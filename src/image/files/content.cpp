#include "image/files/content.h"

#include "image/codes/jpeg.h"
#include "image/openexr/openexr_header.h"
#include "image/codes/png.h"
#include "image/radiance/radiance_header.h"
#include "image/refuse.h"

#include <algorithm>
#include <array>

namespace lambent::image {

Content content_of(std::span<const std::uint8_t> bytes)
{
    if (is_radiance(bytes))
        return Content::radiance;
    if (is_exr(bytes))
        return Content::exr;
    if (is_png(bytes))
        return Content::png;
    return is_jpeg(bytes) ? Content::jpeg : Content::other;
}

Content content_of(ByteSource& source)
{
    std::array<std::uint8_t, 16> bytes{};
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), source.size()));
    source.read(0, bytes.data(), count);
    if (count == 0)
        refuse(source.name(), "is empty");
    return content_of({bytes.data(), count});
}

const char* name_of(Content content)
{
    switch (content) {
    case Content::radiance:
        return "a Radiance HDR";
    case Content::exr:
        return "an OpenEXR";
    case Content::png:
        return "a PNG";
    case Content::jpeg:
        return "a JPEG";
    case Content::other:
        break;
    }
    return "a file of unknown format";
}

} // namespace lambent::image
