#include "image/openexr/openexr_rows.h"

#include <ImfFrameBuffer.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfRgbaFile.h>

#include <vector>

namespace lambent::image {
namespace {

class ColourRows : public ExrRows {
public:
    ColourRows(ExrStream& stream, const ExrChoice& choice, const ExrPart& part, int threads)
        : channels_(choice.channels), part_(part), file_(stream, threads, false), input_(file_, choice.part)
    {
    }

    void read(int first, int count, float* rgb) override
    {
        const auto row_floats = static_cast<std::size_t>(part_.width) * 3;
        const bool grey = channels_[0] == channels_[1];
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < (grey ? 1u : 3u); ++c)
            frame.insert(channels_[c],
                         Imf::Slice::Make(Imf::FLOAT, rgb + c, {part_.min_x, first}, part_.width, count,
                                          3 * sizeof(float), row_floats * sizeof(float)));
        input_.setFrameBuffer(frame);
        input_.readPixels(first, first + count - 1);
        if (grey)
            for (std::size_t i = 0; i < row_floats * static_cast<std::size_t>(count); i += 3)
                rgb[i + 1] = rgb[i + 2] = rgb[i];
    }

private:
    std::array<std::string, 3> channels_;
    ExrPart part_;
    Imf::MultiPartInputFile file_;
    Imf::InputPart input_;
};

class ChromaRows : public ExrRows {
public:
    ChromaRows(ExrStream& stream, const ExrPart& part, int threads) : part_(part), file_(stream, threads) {}

    void read(int first, int count, float* rgb) override
    {
        const auto width = static_cast<std::size_t>(part_.width);
        pixels_.resize(width * static_cast<std::size_t>(count));
        // The library expects a pointer to the origin of the file's coordinates.
        const std::ptrdiff_t origin =
            part_.min_x + static_cast<std::ptrdiff_t>(first) * static_cast<std::ptrdiff_t>(part_.width);
        file_.setFrameBuffer(pixels_.data() - origin, 1, width);
        file_.readPixels(first, first + count - 1);
        for (const Imf::Rgba& pixel : pixels_) {
            *rgb++ = pixel.r;
            *rgb++ = pixel.g;
            *rgb++ = pixel.b;
        }
    }

private:
    ExrPart part_;
    Imf::RgbaInputFile file_;
    std::vector<Imf::Rgba> pixels_;
};

} // namespace

std::unique_ptr<ExrRows> open_exr_rows(ExrStream& stream, const ExrChoice& choice, const ExrPart& part,
                                       int threads)
{
    if (choice.luminance_chroma)
        return std::make_unique<ChromaRows>(stream, part, threads);
    return std::make_unique<ColourRows>(stream, choice, part, threads);
}

} // namespace lambent::image
