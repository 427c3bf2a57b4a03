#include "image/radiance/radiance_stream.h"

#include "image/refuse.h"

#include <algorithm>
#include <cstring>

namespace lambent::image {
namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 19;

// Enough pixels to be worth waking a thread, few enough for their floats to stay in its cache.
constexpr int batch_pixels = 1 << 16;

void interleave(const std::uint8_t* planes, std::size_t count, Rgbe* pixels)
{
    for (std::size_t i = 0; i < count; ++i)
        pixels[i] = {planes[i], planes[count + i], planes[2 * count + i], planes[3 * count + i]};
}

// Buffers for one decoded scanline, as planes or as pixels.
struct Scratch {
    explicit Scratch(int length)
        : planes(static_cast<std::size_t>(length) * 4 + scanline_slack),
          pixels(static_cast<std::size_t>(length))
    {
    }
    std::vector<std::uint8_t> planes;
    std::vector<Rgbe> pixels;
};

} // namespace

void ScanlineBatch::to_rgb(int length, const ChannelScale& scale, float* rgb) const
{
    Scratch scratch(length);
    const auto count = static_cast<std::size_t>(length);
    for (const Located& located : scanlines_) {
        switch (located.scanline.kind) {
        case ScanlineKind::planes:
            decode_planes(located.bytes, length, scratch.planes.data());
            planes_to_rgb(scratch.planes.data(), count, scale, rgb);
            break;
        case ScanlineKind::pixels:
            decode_pixels(located.bytes, length, scratch.pixels.data());
            pixels_to_rgb(scratch.pixels.data(), count, scale, rgb);
            break;
        case ScanlineKind::flat:
            std::memcpy(scratch.pixels.data(), located.bytes, count * 4);
            pixels_to_rgb(scratch.pixels.data(), count, scale, rgb);
            break;
        }
        rgb += count * 3;
    }
}

void ScanlineBatch::append_to(std::vector<Rgbe>& pixels, int length) const
{
    Scratch scratch(length);
    const auto count = static_cast<std::size_t>(length);
    for (const Located& located : scanlines_) {
        pixels.resize(pixels.size() + count);
        Rgbe* const to = pixels.data() + pixels.size() - count;
        if (located.scanline.kind == ScanlineKind::planes) {
            decode_planes(located.bytes, length, scratch.planes.data());
            interleave(scratch.planes.data(), count, to);
        } else {
            decode_pixels(located.bytes, length, to);
        }
    }
}

ScanlineStream::ScanlineStream(std::unique_ptr<ByteSource> source, const RadianceHeader& header)
    : source_(std::move(source)), length_(header.scanline_length()), next_offset_(header.length)
{
}

void ScanlineStream::refill()
{
    const std::uint64_t left = source_->size() - next_offset_;
    if (left == 0)
        refuse(source_->name(), "ends in scanline ", found_, ", after ", source_->size(), " bytes");
    const std::size_t kept = end_ - begin_;
    const std::size_t room = block_bytes + max_scanline_bytes(length_);
    const std::size_t added = static_cast<std::size_t>(std::min<std::uint64_t>(left, room - kept));
    std::shared_ptr<std::uint8_t[]> block(new std::uint8_t[room + scanline_slack]);
    if (kept > 0)
        std::memcpy(block.get(), block_.get() + begin_, kept);
    source_->read(next_offset_, block.get() + kept, added);
    std::memset(block.get() + kept + added, 0, scanline_slack);
    next_offset_ += added;
    block_ = std::move(block);
    begin_ = 0;
    end_ = kept + added;
}

ScanlineBatch ScanlineStream::next(int most)
{
    ScanlineBatch batch;
    most = std::min(most, std::max(1, batch_pixels / length_));
    while (batch.size() < most) {
        const std::uint8_t* const bytes = block_.get() + begin_;
        const auto scanline = find_scanline({bytes, end_ - begin_}, length_, {source_->name(), found_});
        if (scanline) {
            batch.scanlines_.push_back({*scanline, bytes});
            begin_ += scanline->bytes;
            ++found_;
        } else if (batch.size() > 0) {
            break;
        } else {
            refill();
        }
    }
    batch.block_ = block_;
    return batch;
}

} // namespace lambent::image
