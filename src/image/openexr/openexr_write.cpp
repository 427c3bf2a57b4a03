#include "image/openexr/openexr.h"

#include "image/openexr/openexr_threads.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace lambent::image {
namespace {

class MemoryStream : public Imf::OStream {
public:
    MemoryStream() : Imf::OStream("memory") {}

    void write(const char* bytes, int count) override
    {
        const auto length = static_cast<std::size_t>(count);
        if (bytes_.size() < at_ + length)
            bytes_.resize(at_ + length);
        std::memcpy(bytes_.data() + at_, bytes, length);
        at_ += length;
    }

    uint64_t tellp() override { return at_; }
    void seekp(uint64_t position) override { at_ = position; }

    std::vector<std::uint8_t> take() { return std::move(bytes_); }

private:
    std::vector<std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

constexpr const char* channel_names[] = {"R", "G", "B", "A"};

// Writes channels of `type`, interleaved in memory.
std::vector<std::uint8_t> encode(const RadianceImage& image, Imf::Header header, Imf::PixelType type,
                                 const void* values)
{
    Imf::FrameBuffer frame;
    const std::size_t value_bytes = type == Imf::HALF ? 2 : 4;
    const std::size_t pixel_bytes = static_cast<std::size_t>(image.channels) * value_bytes;
    for (int c = 0; c < image.channels; ++c) {
        header.channels().insert(channel_names[c], Imf::Channel(type));
        // The library only reads from the slices of an output file, though it asks for a char*.
        char* const base =
            const_cast<char*>(static_cast<const char*>(values)) + static_cast<std::size_t>(c) * value_bytes;
        frame.insert(channel_names[c], Imf::Slice(type, base, pixel_bytes,
                                                  pixel_bytes * static_cast<std::size_t>(image.width)));
    }
    MemoryStream stream;
    {
        constexpr std::uint64_t rows_at_once = 16;
        const int threads =
            exr_threads(std::int64_t{image.width} * image.height,
                        2 * rows_at_once * pixel_bytes * static_cast<std::uint64_t>(image.width));
        Imf::OutputFile file(stream, header, threads);
        file.setFrameBuffer(frame);
        file.writePixels(image.height);
    }
    return stream.take();
}

} // namespace

std::vector<std::uint8_t> encode_exr(const RadianceImage& image, const Notes& notes)
{
    Imf::Header header(image.width, image.height);
    for (const Note& note : notes)
        header.insert(note.key, Imf::StringAttribute(note.value));
    header.compression() = Imf::ZIP_COMPRESSION;
    return encode(image, std::move(header), Imf::FLOAT, image.values.data());
}

std::vector<std::uint8_t> encode_small_exr(const RadianceImage& image, float loss)
{
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::DWAB_COMPRESSION;
    header.dwaCompressionLevel() = loss;
    std::vector<half> halfs;
    halfs.reserve(image.values.size());
    for (const float value : image.values)
        halfs.emplace_back(std::min(value, static_cast<float>(HALF_MAX)));
    return encode(image, std::move(header), Imf::HALF, halfs.data());
}

} // namespace lambent::image
