// Any bytes as a Radiance picture: read or refused with an Error; anything else is a crash.
#include "image/radiance/radiance_hdr.h"

#include <algorithm>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lambent::image;
    try {
        const auto reader = open_radiance_hdr(open_bytes({data, size}, "fuzz"));
        // A few kilobytes of repeats may stand for hundreds of millions of pixels: true, but slow.
        constexpr std::int64_t most = std::int64_t{1} << 20;
        if (std::int64_t{reader->width()} * reader->height() > most)
            return 0;
        constexpr int rows = 16;
        std::vector<float> band(static_cast<std::size_t>(reader->width()) * rows * 3);
        for (int y = 0; y < reader->height(); y += rows)
            reader->read_rows(std::min(rows, reader->height() - y), band.data());
    } catch (const lambent::Error&) {
    }
    return 0;
}
