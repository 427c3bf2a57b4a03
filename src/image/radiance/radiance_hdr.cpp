#include "image/radiance/radiance_hdr.h"

#include "image/radiance/radiance_header.h"
#include "image/radiance/radiance_stream.h"
#include "image/refuse.h"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <utility>

namespace lambent::image {
namespace {

RadianceHeader header_of(ByteSource& source)
{
    std::vector<std::uint8_t> bytes(
        static_cast<std::size_t>(std::min<std::uint64_t>(source.size(), max_radiance_header)));
    source.read(0, bytes.data(), bytes.size());
    RadianceHeader header = read_radiance_header(bytes, source.name());
    // A scanline has at least one pixel, and a repeat count if it has several.
    const std::uint64_t least = header.scanline_length() > 1 ? 8 : 4;
    if ((source.size() - header.length) / least < static_cast<std::uint64_t>(header.scanlines()))
        refuse(source.name(), "a file of ", source.size(), " bytes cannot hold the ", header.width, "x",
               header.height, " pixels its header claims");
    return header;
}

class HdrReader : public RadianceReader {
public:
    HdrReader(std::unique_ptr<ByteSource> source, const RadianceHeader& header)
        : header_(header), stream_(std::move(source), header)
    {
        width_ = header.width;
        height_ = header.height;
    }

    void read_rows(int count, float* rgb) override
    {
        if (header_.order.usual())
            stream_rows(count, rgb);
        else
            copy_rows(count, rgb);
        row_ += count;
    }

private:
    struct Work {
        ScanlineBatch batch;
        float* rgb;
    };

    // One thread finds the scanlines, all threads decode them.
    void stream_rows(int count, float* rgb)
    {
        const auto find = [&](tbb::flow_control& control) -> Work {
            if (count == 0) {
                control.stop();
                return {};
            }
            Work work{stream_.next(count), rgb};
            count -= work.batch.size();
            rgb += static_cast<std::size_t>(work.batch.size()) * static_cast<std::size_t>(width_) * 3;
            return work;
        };
        const auto decode = [&](const Work& work) { work.batch.to_rgb(width_, header_.scale, work.rgb); };
        const auto in_flight = static_cast<std::size_t>(2 * tbb::this_task_arena::max_concurrency());
        tbb::parallel_pipeline(in_flight,
                               tbb::make_filter<void, Work>(tbb::filter_mode::serial_in_order, find) &
                                   tbb::make_filter<Work, void>(tbb::filter_mode::parallel, decode));
    }

    void copy_rows(int count, float* rgb)
    {
        if (pixels_.empty())
            read_pixels();
        std::vector<Rgbe> row(static_cast<std::size_t>(width_));
        for (int y = row_; y < row_ + count; ++y) {
            for (int x = 0; x < width_; ++x)
                row[static_cast<std::size_t>(x)] = pixels_[stored_at(x, y)];
            pixels_to_rgb(row.data(), row.size(), header_.scale, rgb);
            rgb += row.size() * 3;
        }
    }

    void read_pixels()
    {
        const int scanlines = header_.scanlines();
        const int length = header_.scanline_length();
        // Reserved pages take no memory until the scanlines that the file really has are appended.
        pixels_.reserve(static_cast<std::size_t>(scanlines) * static_cast<std::size_t>(length));
        for (int found = 0; found < scanlines;) {
            const ScanlineBatch batch = stream_.next(scanlines - found);
            batch.append_to(pixels_, length);
            found += batch.size();
        }
    }

    std::size_t stored_at(int x, int y) const
    {
        const int from_left = header_.order.right_first ? width_ - 1 - x : x;
        const int from_top = header_.order.bottom_first ? height_ - 1 - y : y;
        const auto [scanline, pixel] =
            header_.order.columns ? std::pair(from_left, from_top) : std::pair(from_top, from_left);
        return static_cast<std::size_t>(scanline) * static_cast<std::size_t>(header_.scanline_length()) +
               static_cast<std::size_t>(pixel);
    }

    RadianceHeader header_;
    ScanlineStream stream_;
    int row_ = 0;
    std::vector<Rgbe> pixels_; ///< the whole image in file order, unless that order is the usual one
};

} // namespace

std::unique_ptr<RadianceReader> open_radiance_hdr(std::unique_ptr<ByteSource> source)
{
    const RadianceHeader header = header_of(*source);
    return std::make_unique<HdrReader>(std::move(source), header);
}

ImageInfo inspect_radiance_hdr(ByteSource& source)
{
    const RadianceHeader header = header_of(source);
    return {"Radiance HDR", text("8-bit RGB with a shared exponent, ", header.resolution), header.width,
            header.height};
}

} // namespace lambent::image
