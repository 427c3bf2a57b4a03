#include "image/radiance/radiance_hdr.h"

#include "base/text.h"
#include "image/radiance/radiance_scanline.h"
#include "image/radiance/rgbe.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace lambent::image {
namespace {

// A run of fewer than four bytes would not be shorter than the same bytes in the literals around it.
constexpr std::size_t shortest_run = 4;
constexpr std::size_t longest_run = 127;
constexpr std::size_t most_literals = 128;

std::size_t run_at(const std::uint8_t* plane, std::size_t at, std::size_t length)
{
    const std::size_t limit = std::min(length, at + longest_run);
    std::size_t end = at + 1;
    while (end < limit && plane[end] == plane[at])
        ++end;
    return end - at;
}

void append_literals(std::vector<std::uint8_t>& out, const std::uint8_t* bytes, std::size_t count)
{
    while (count > 0) {
        const std::size_t some = std::min(count, most_literals);
        out.push_back(static_cast<std::uint8_t>(some));
        out.insert(out.end(), bytes, bytes + some);
        bytes += some;
        count -= some;
    }
}

void append_plane(std::vector<std::uint8_t>& out, const std::uint8_t* plane, std::size_t length)
{
    std::size_t literal = 0; // start of the bytes not yet written
    for (std::size_t at = 0; at < length;) {
        const std::size_t run = run_at(plane, at, length);
        if (run >= shortest_run) {
            append_literals(out, plane + literal, at - literal);
            out.push_back(static_cast<std::uint8_t>(most_literals + run));
            out.push_back(plane[at]);
            literal = at + run;
        }
        at += run;
    }
    append_literals(out, plane + literal, length - literal);
}

void append_planes(std::vector<std::uint8_t>& out, const std::vector<Rgbe>& row)
{
    const auto high = static_cast<std::uint8_t>(row.size() >> 8),
               low = static_cast<std::uint8_t>(row.size() & 255);
    out.insert(out.end(), {2, 2, high, low});
    std::vector<std::uint8_t> plane(row.size());
    for (std::size_t channel = 0; channel < 4; ++channel) {
        std::transform(row.begin(), row.end(), plane.begin(),
                       [&](const Rgbe& pixel) { return pixel[channel]; });
        append_plane(out, plane.data(), plane.size());
    }
}

std::vector<std::uint8_t> encode_rows(const RadianceImage& image, int first, int last)
{
    std::vector<std::uint8_t> out;
    out.reserve(static_cast<std::size_t>(last - first) * static_cast<std::size_t>(image.width) * 4);
    std::vector<Rgbe> row(static_cast<std::size_t>(image.width));
    for (int y = first; y < last; ++y) {
        const float* pixel = image.pixel(0, y);
        for (Rgbe& codes : row) {
            codes = to_rgbe(pixel[0], pixel[1], pixel[2]);
            pixel += image.channels;
        }
        if (has_planes(image.width))
            append_planes(out, row);
        else
            for (const Rgbe& codes : row)
                out.insert(out.end(), codes.begin(), codes.end());
    }
    return out;
}

} // namespace

std::vector<std::uint8_t> encode_radiance_hdr(const RadianceImage& image, const Notes& notes)
{
    constexpr int band = 16;
    std::vector<std::vector<std::uint8_t>> bands(static_cast<std::size_t>((image.height + band - 1) / band));
    tbb::parallel_for(0, static_cast<int>(bands.size()), [&](int i) {
        bands[static_cast<std::size_t>(i)] =
            encode_rows(image, i * band, std::min((i + 1) * band, image.height));
    });
    std::string comments;
    for (const Note& note : notes)
        comments += text("# ", note.key, ": ", note.value, "\n");
    const std::string header =
        text("#?RADIANCE\n", comments, "SOFTWARE=lambent\nFORMAT=32-bit_rle_rgbe\n\n-Y ", image.height,
             " +X ", image.width, "\n");
    std::size_t size = header.size();
    for (const std::vector<std::uint8_t>& rows : bands)
        size += rows.size();
    std::vector<std::uint8_t> out;
    out.reserve(size);
    out.insert(out.end(), header.begin(), header.end());
    for (const std::vector<std::uint8_t>& rows : bands)
        out.insert(out.end(), rows.begin(), rows.end());
    return out;
}

} // namespace lambent::image
