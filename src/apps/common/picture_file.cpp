#include "apps/common/picture_file.h"

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "image/files/image_io.h"
#include "image/codes/jpeg.h"
#include "image/codes/png.h"

#include <algorithm>

namespace lambent::cli {
namespace {

image::CodeImage with_alpha(const image::RadianceImage& picture, const display::Settings& display)
{
    image::RadianceImage bare = picture;
    for (std::size_t i = 0; i < bare.values.size(); i += 4)
        if (const float coverage = bare.values[i + 3]; coverage > 0.0f)
            for (std::size_t c = 0; c < 4; ++c) {
                if (c < 3)
                    bare.values[i + c] /= coverage;
                if (!bare.unlit.empty())
                    bare.unlit[i + c] /= coverage;
            }
    const image::CodeImage color = display::to_codes(bare, display);
    image::CodeImage codes{picture.width, picture.height, 4, 8, {}};
    codes.bytes.resize(color.bytes.size() / 3 * 4);
    for (std::size_t i = 0; i < color.bytes.size() / 3; ++i) {
        std::copy_n(color.bytes.data() + 3 * i, 3, codes.bytes.data() + 4 * i);
        const float coverage = std::clamp(picture.values[4 * i + 3], 0.0f, 1.0f);
        codes.bytes[4 * i + 3] = static_cast<std::uint8_t>(coverage * 255.0f + 0.5f);
    }
    return codes;
}

} // namespace

void check_picture_file(const std::filesystem::path& path)
{
    if (image::file_kind(path) == image::FileKind::unknown)
        throw Error(Failure::usage,
                    text(path.string(), ": a picture's name ends in .png, .jpg, .exr or .hdr"));
    check_can_write(path);
}

void write_picture(const image::RadianceImage& picture, const display::Settings& display, bool transparent,
                   const std::filesystem::path& path, const image::Notes& notes)
{
    const image::FileKind kind = image::file_kind(path);
    if (kind == image::FileKind::exr || kind == image::FileKind::hdr)
        image::write_radiance(picture, path, notes);
    else
        image::write_codes(picture_codes(picture, display, transparent && kind == image::FileKind::png), path,
                           notes);
}

image::CodeImage picture_codes(const image::RadianceImage& picture, const display::Settings& display,
                               bool transparent)
{
    return transparent ? with_alpha(picture, display) : display::to_codes(picture, display);
}

std::vector<std::uint8_t> picture_bytes(const image::RadianceImage& picture, const display::Settings& display,
                                        bool transparent, const std::filesystem::path& path,
                                        const image::Notes& notes)
{
    const bool png = image::file_kind(path) == image::FileKind::png;
    if (!png && image::file_kind(path) != image::FileKind::jpeg)
        throw Error(Failure::usage, text(path.string(), ": a displayed picture is written as .png or .jpg"));
    const image::CodeImage codes = picture_codes(picture, display, transparent && png);
    return png ? image::encode_png(codes, {}, notes) : image::encode_jpeg(codes, {}, notes);
}

} // namespace lambent::cli
