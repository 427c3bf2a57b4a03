#include "image/openexr.h"

#include "image/openexr_threads.h"
#include "image/refuse.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string_view>

namespace lambent::image {
namespace {

constexpr char nameless[] = "it";

// What the library says, without the "Cannot ... image file "it". " before the reason.
[[noreturn]] void refuse_for(const std::exception& error, const std::string& name)
{
    const std::string_view line = error.what();
    const std::string opening = text('"', nameless, "\". ");
    const std::size_t at = line.find(opening);
    refuse(name, "not a valid OpenEXR file: ",
           printable(at == std::string_view::npos ? line : line.substr(at + opening.size()), 200));
}

// A ByteSource as the library wants it, with the checked header in place of the one in the file.
class ExrStream : public Imf::IStream {
public:
    ExrStream(ByteSource& source, std::vector<std::uint8_t> header)
        : Imf::IStream(nameless), source_(source), header_(std::move(header))
    {
    }

    // Returns whether more can be read, by the library's contract.
    bool read(char* out, int count) override
    {
        auto left = static_cast<std::size_t>(std::max(count, 0));
        if (at_ < header_.size()) {
            const std::size_t some = std::min(left, header_.size() - static_cast<std::size_t>(at_));
            std::memcpy(out, header_.data() + at_, some);
            at_ += some;
            out += some;
            left -= some;
        }
        source_.read(at_, out, left);
        at_ += left;
        return at_ < source_.size();
    }

    uint64_t tellg() override { return at_; }
    void seekg(uint64_t position) override { at_ = position; }

private:
    ByteSource& source_;
    std::vector<std::uint8_t> header_;
    std::uint64_t at_ = 0;
};

// The channels that make red, green and blue; all three the same for grey.
using Colour = std::array<std::string, 3>;

bool has_channel(const ExrPart& part, const std::string& name)
{
    return std::ranges::find(part.channels, name, &ExrChannel::name) != part.channels.end();
}

std::optional<Colour> find_colour(const ExrPart& part)
{
    const auto in_layer = [&](const std::string& layer) -> std::optional<Colour> {
        Colour colour = {layer + "R", layer + "G", layer + "B"};
        const bool all =
            std::ranges::all_of(colour, [&](const std::string& name) { return has_channel(part, name); });
        return all ? std::optional(colour) : std::nullopt;
    };
    if (auto colour = in_layer(""))
        return colour;
    for (const ExrChannel& channel : part.channels)
        if (auto colour = in_layer(channel.name.substr(0, channel.name.rfind('.') + 1)))
            return colour;
    const bool chroma = has_channel(part, "RY") || has_channel(part, "BY");
    return has_channel(part, "Y") && !chroma ? std::optional(Colour{"Y", "Y", "Y"}) : std::nullopt;
}

struct Choice {
    int part;
    Colour colour;
};

[[noreturn]] void refuse_channels(const ExrHeader& header, const std::string& name)
{
    std::string channels;
    for (const ExrPart& part : header.parts) {
        if (part.deep)
            refuse(name, "deep images are not supported");
        if (has_channel(part, "RY") || has_channel(part, "BY"))
            refuse(name, "luminance-chroma images (channels Y, RY, BY) are not supported");
        for (const ExrChannel& channel : part.channels)
            channels += (channels.empty() ? "" : ", ") + channel.name;
    }
    refuse(name, "has no channels R, G and B and no Y; its channels are ", printable(channels));
}

Choice choose(const ExrHeader& header, const std::string& name)
{
    for (std::size_t i = 0; i < header.parts.size(); ++i) {
        const ExrPart& part = header.parts[i];
        const auto colour = part.deep ? std::nullopt : find_colour(part);
        if (!colour)
            continue;
        for (const ExrChannel& channel : part.channels)
            if (std::ranges::count(*colour, channel.name) > 0 &&
                (channel.x_sampling != 1 || channel.y_sampling != 1))
                refuse(name, "its channel ", printable(channel.name),
                       " is subsampled, which is not supported");
        return {static_cast<int>(i), *colour};
    }
    refuse_channels(header, name);
}

class ExrReader : public RadianceReader {
public:
    ExrReader(std::unique_ptr<ByteSource> source, ExrHeader header)
        : source_(std::move(source)), choice_(choose(header, source_->name())),
          part_(header.parts[static_cast<std::size_t>(choice_.part)]),
          stream_(*source_, std::move(header.bytes)), file_(stream_, threads(), false),
          input_(file_, choice_.part)
    {
        width_ = part_.width;
        height_ = part_.height;
    }

    void read_rows(int count, float* rgb) override
    try {
        const auto row_floats = static_cast<std::size_t>(width_) * 3;
        const int first = part_.min_y + row_;
        const bool grey = choice_.colour[0] == choice_.colour[1];
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < (grey ? 1u : 3u); ++c)
            frame.insert(choice_.colour[c],
                         Imf::Slice::Make(Imf::FLOAT, rgb + c, {part_.min_x, first}, width_, count,
                                          3 * sizeof(float), row_floats * sizeof(float)));
        input_.setFrameBuffer(frame);
        input_.readPixels(first, first + count - 1);
        if (grey)
            for (std::size_t i = 0; i < row_floats * static_cast<std::size_t>(count); i += 3)
                rgb[i + 1] = rgb[i + 2] = rgb[i];
        row_ += count;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        refuse_for(error, source_->name());
    }

private:
    int threads() const
    {
        return part_.compression == 0
                   ? 0
                   : exr_threads(std::int64_t{part_.width} * part_.height, 2 * part_.decoded_chunk_bytes());
    }

    std::unique_ptr<ByteSource> source_;
    Choice choice_;
    ExrPart part_;
    ExrStream stream_;
    Imf::MultiPartInputFile file_;
    Imf::InputPart input_;
    int row_ = 0;
};

std::string describe(const ExrPart& part)
{
    static constexpr std::array<const char*, 3> pixels = {"32-bit integer", "16-bit float", "32-bit float"};
    std::string channels;
    for (const ExrChannel& channel : part.channels)
        channels += (channels.empty() ? "" : " ") + channel.name;
    const ExrPixel pixel = part.channels.empty() ? ExrPixel::half : part.channels.front().pixel;
    return text(pixels[static_cast<std::size_t>(pixel)], " ", printable(channels), ", ",
                part.compression_name(), part.tiled ? ", tiled" : "");
}

} // namespace

std::unique_ptr<RadianceReader> open_exr(std::unique_ptr<ByteSource> source)
{
    const std::string name = source->name();
    ExrHeader header = read_exr_header(*source);
    try {
        return std::make_unique<ExrReader>(std::move(source), std::move(header));
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        refuse_for(error, name);
    }
}

ImageInfo inspect_exr(ByteSource& source)
{
    const ExrHeader header = read_exr_header(source);
    const Choice choice = choose(header, source.name());
    const ExrPart& part = header.parts[static_cast<std::size_t>(choice.part)];
    return {"OpenEXR", describe(part), part.width, part.height};
}

} // namespace lambent::image
