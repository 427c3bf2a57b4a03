#include "image/openexr/openexr.h"

#include "image/openexr/openexr_channels.h"
#include "image/openexr/openexr_rows.h"
#include "image/openexr/openexr_threads.h"
#include "image/refuse.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace lambent::image {
namespace {

// Refuses a file for the reason in the library's message, which begins with "Cannot ... image file "it". ".
[[noreturn]] void refuse_for(const std::exception& error, const std::string& name)
{
    const std::string_view line = error.what();
    const std::string opening = text('"', exr_stream_name, "\". ");
    const std::size_t at = line.find(opening);
    refuse(name, "not a valid OpenEXR file: ",
           printable(at == std::string_view::npos ? line : line.substr(at + opening.size()), 200));
}

// Largest display window of a file that stores fewer pixels: this many, or as many times the stored ones.
constexpr std::int64_t always_allowed_pixels = std::int64_t{1} << 25, max_times_stored = 16;

// The window that is read: the display window, or the data window of an environment map.
ExrWindow shown_window(const ExrPart& part, const std::string& name)
{
    const ExrWindow data = part.data_window();
    if (part.projection != Projection::unknown)
        return data;
    const ExrWindow& shown = part.display;
    check_size(name, shown.width, shown.height);
    const std::int64_t pixels = std::int64_t{shown.width} * shown.height,
                       stored = std::int64_t{data.width} * data.height;
    if (pixels > std::max(always_allowed_pixels, max_times_stored * stored))
        refuse(name, "its display window of ", shown.width, "x", shown.height, " is far larger than the ",
               data.width, "x", data.height, " pixels it stores");
    const auto apart = [](int a, int length, int b, int other) {
        return std::int64_t{a} + length <= b || std::int64_t{b} + other <= a;
    };
    if (apart(shown.min_x, shown.width, data.min_x, data.width) ||
        apart(shown.min_y, shown.height, data.min_y, data.height))
        refuse(name, "its data window ", data.width, "x", data.height, " at ", data.min_x, ",", data.min_y,
               " lies outside its display window ", shown.width, "x", shown.height, " at ", shown.min_x, ",",
               shown.min_y);
    return shown;
}

class ExrReader : public RadianceReader {
public:
    ExrReader(std::unique_ptr<ByteSource> source, ExrHeader header, ExrChoice choice, bool is_colour)
        : source_(std::move(source)), choice_(std::move(choice)),
          part_(header.parts[static_cast<std::size_t>(choice_.part)]),
          shown_(shown_window(part_, source_->name())), stream_(*source_, std::move(header.bytes)),
          rows_(open_exr_rows(stream_, choice_, part_, threads()))
    {
        width_ = shown_.width;
        height_ = shown_.height;
        projection_ = part_.projection;
        for (const std::string& warning : part_.warnings)
            warnings_.push_back(text(source_->name(), ": ", warning));
        if (part_.primaries && is_colour)
            if (const ColourMatrix matrix = *to_rec709(*part_.primaries); !is_identity(matrix))
                matrix_ = matrix;
    }

    void read_rows(int count, float* rgb) override
    try {
        const int first = shown_.min_y + row_;
        if (shown_ == part_.data_window())
            rows_->read(first, count, rgb);
        else
            read_window(first, count, rgb);
        if (matrix_)
            convert({rgb, 3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(count)});
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

    // Reads rows of the display window, black where the data window has no pixels. Pixels outside it are left out.
    void read_window(int first, int count, float* rgb)
    {
        constexpr int at_once = 64;
        const auto row_floats = static_cast<std::size_t>(width_) * 3;
        std::fill_n(rgb, row_floats * static_cast<std::size_t>(count), 0.0f);
        const int left = std::max(shown_.min_x, part_.min_x);
        const int right = std::min(shown_.min_x + shown_.width, part_.min_x + part_.width);
        const int end = std::min(first + count, part_.min_y + part_.height);
        for (int y = std::max(first, part_.min_y); y < end; y += at_once) {
            const int some = std::min(at_once, end - y);
            stored_.resize(static_cast<std::size_t>(part_.width) * 3 * static_cast<std::size_t>(some));
            rows_->read(y, some, stored_.data());
            for (int i = 0; i < some; ++i)
                std::copy_n(stored_.data() +
                                3 * (static_cast<std::size_t>(i) * static_cast<std::size_t>(part_.width) +
                                     static_cast<std::size_t>(left - part_.min_x)),
                            3 * static_cast<std::size_t>(right - left),
                            rgb + static_cast<std::size_t>(y + i - first) * row_floats +
                                3 * static_cast<std::size_t>(left - shown_.min_x));
        }
    }

    void convert(std::span<float> rgb) const
    {
        for (std::size_t i = 0; i < rgb.size(); i += 3) {
            const double c[3] = {rgb[i], rgb[i + 1], rgb[i + 2]};
            for (std::size_t k = 0; k < 3; ++k)
                rgb[i + k] = static_cast<float>((*matrix_)[k][0] * c[0] + (*matrix_)[k][1] * c[1] +
                                                (*matrix_)[k][2] * c[2]);
        }
    }

    std::unique_ptr<ByteSource> source_;
    ExrChoice choice_;
    ExrPart part_;
    ExrWindow shown_;
    ExrStream stream_;
    std::unique_ptr<ExrRows> rows_;
    std::optional<ColourMatrix> matrix_;
    std::vector<float> stored_;
    int row_ = 0;
};

std::string describe(const ExrPart& part)
{
    static constexpr std::array<const char*, 3> pixels = {"32-bit integer", "16-bit float", "32-bit float"};
    std::string channels;
    for (const ExrChannel& channel : part.channels)
        channels += (channels.empty() ? "" : " ") + channel.name;
    const ExrPixel pixel = part.channels.empty() ? ExrPixel::half : part.channels.front().pixel;
    std::string line = text(pixels[static_cast<std::size_t>(pixel)], " ", printable(channels), ", ",
                            part.compression_name(), part.tiled ? ", tiled" : "");
    if (part.projection != Projection::unknown)
        line += part.projection == Projection::cube ? ", cube map" : ", latitude-longitude map";
    else if (part.display != part.data_window())
        line += text(", of which ", part.width, "x", part.height, " at ", part.min_x - part.display.min_x,
                     ",", part.min_y - part.display.min_y, " are stored");
    if (part.primaries && !is_identity(*to_rec709(*part.primaries)))
        line += ", other primaries than Rec. 709";
    return line;
}

std::unique_ptr<RadianceReader> open_channels(std::unique_ptr<ByteSource> source, bool is_colour)
{
    const std::string name = source->name();
    ExrHeader header = read_exr_header(*source);
    std::optional<ExrChoice> choice = choose_channels(header, name);
    if (!is_colour)
        choice = choose_alpha(header, *choice);
    if (!choice)
        return nullptr;
    try {
        return std::make_unique<ExrReader>(std::move(source), std::move(header), *choice, is_colour);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        refuse_for(error, name);
    }
}

} // namespace

std::unique_ptr<RadianceReader> open_exr(std::unique_ptr<ByteSource> source)
{
    return open_channels(std::move(source), true);
}

std::unique_ptr<RadianceReader> open_exr_alpha(std::unique_ptr<ByteSource> source)
{
    return open_channels(std::move(source), false);
}

ImageInfo inspect_exr(ByteSource& source)
{
    const ExrHeader header = read_exr_header(source);
    const ExrChoice choice = choose_channels(header, source.name());
    const ExrPart& part = header.parts[static_cast<std::size_t>(choice.part)];
    const ExrWindow shown = shown_window(part, source.name());
    return {"OpenEXR", describe(part), shown.width, shown.height};
}

} // namespace lambent::image
