#include "image/image_io.h"

#include "base/file.h"
#include "image/jpeg.h"
#include "image/png.h"
#include "image/refuse.h"

#include <algorithm>
#include <cctype>

namespace lambent::image {
namespace {

// The largest image, stored without any compression, and room for metadata.
constexpr std::uint64_t max_codes_file = (std::uint64_t{1} << 31) + (std::uint64_t{1} << 26);

void check_writable(const CodeImage& image, const std::filesystem::path& path)
{
    const std::int64_t pixels = std::int64_t{image.width} * image.height;
    const bool sane = image.width > 0 && image.height > 0 && image.width <= max_side &&
                      image.height <= max_side && pixels <= max_pixels &&
                      (image.channels == 3 || image.channels == 4) && (image.bits == 8 || image.bits == 16);
    if (!sane || image.bytes.size() != static_cast<std::size_t>(pixels * image.channels * image.bits / 8))
        throw Error(Failure::usage, text(path.string(), ": cannot write an image of ", image.width, "x",
                                         image.height, ", ", image.channels, " channels of ", image.bits,
                                         " bits in ", image.bytes.size(), " bytes"));
}

} // namespace

FileKind file_kind(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    for (char& c : extension)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (extension == ".png")
        return FileKind::png;
    if (extension == ".jpg" || extension == ".jpeg")
        return FileKind::jpeg;
    if (extension == ".exr")
        return FileKind::exr;
    if (extension == ".hdr")
        return FileKind::hdr;
    return FileKind::unknown;
}

CodeImage decode_codes(std::span<const std::uint8_t> bytes, const std::string& name)
{
    if (is_png(bytes))
        return decode_png(bytes, name);
    if (is_jpeg(bytes))
        return decode_jpeg(bytes, name);
    refuse(name, "neither a PNG nor a JPEG");
}

CodeImage read_codes(const std::filesystem::path& path)
{
    return decode_codes(read_file(path, max_codes_file), path.string());
}

void write_codes(const CodeImage& image, const std::filesystem::path& path)
{
    check_writable(image, path);
    const FileKind kind = file_kind(path);
    if (kind != FileKind::png && kind != FileKind::jpeg)
        throw Error(Failure::usage, text(path.string(), ": codes are written as .png or .jpg"));
    if (kind == FileKind::jpeg && image.bits != 8)
        throw Error(Failure::usage, text(path.string(), ": a JPEG cannot hold ", image.bits, "-bit codes"));
    check_can_write(path);
    write_file(path, kind == FileKind::png ? encode_png(image) : encode_jpeg(image));
}

} // namespace lambent::image
