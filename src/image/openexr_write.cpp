#include "image/openexr.h"

#include "image/openexr_threads.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>

#include <cstring>

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

} // namespace

std::vector<std::uint8_t> encode_exr(const RadianceImage& image)
{
    static constexpr const char* names[] = {"R", "G", "B", "A"};
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    const std::size_t pixel_bytes = static_cast<std::size_t>(image.channels) * sizeof(float);
    for (int c = 0; c < image.channels; ++c) {
        header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
        // The library only reads from the slices of an output file, though it asks for a char*.
        char* const base = const_cast<char*>(reinterpret_cast<const char*>(image.values.data() + c));
        frame.insert(names[c], Imf::Slice(Imf::FLOAT, base, pixel_bytes,
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

} // namespace lambent::image
