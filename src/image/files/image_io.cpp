#include "image/files/image_io.h"

#include "base/file.h"
#include "image/byte_source.h"
#include "image/files/content.h"
#include "image/codes/jpeg.h"
#include "image/openexr/openexr.h"
#include "image/openexr/openexr_map.h"
#include "image/codes/png.h"
#include "image/radiance/radiance_hdr.h"
#include "image/refuse.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace lambent::image {
namespace {

// Size of the largest image without compression, plus metadata.
constexpr std::uint64_t max_codes_file = (std::uint64_t{1} << 31) + (std::uint64_t{1} << 26);

std::vector<std::uint8_t> read_all(ByteSource& source)
{
    if (source.size() > max_codes_file)
        refuse(source.name(), source.size(), " bytes is more than any supported image needs");
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(source.size()));
    source.read(0, bytes.data(), bytes.size());
    return bytes;
}

template <class Image>
void check_writable(const Image& image, std::size_t elements, const std::filesystem::path& path)
{
    const std::int64_t pixels = std::int64_t{image.width} * image.height;
    if (image.width <= 0 || image.height <= 0 || image.width > max_side || image.height > max_side ||
        pixels > max_pixels || (image.channels != 3 && image.channels != 4) ||
        elements != static_cast<std::size_t>(pixels * image.channels))
        throw Error(Failure::usage,
                    text(path.string(), ": cannot write an image of ", image.width, "x", image.height,
                         " pixels with ", image.channels, " channels and ", elements, " values"));
}

std::unique_ptr<RadianceReader> open_radiance(std::unique_ptr<ByteSource> source)
{
    const Content content = content_of(*source);
    if (content == Content::radiance)
        return open_radiance_hdr(std::move(source));
    if (content == Content::exr)
        return open_exr(std::move(source));
    refuse(source->name(), "is ", name_of(content), ", not Radiance HDR or OpenEXR");
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

std::unique_ptr<RadianceReader> open_radiance(const std::filesystem::path& path)
{
    return open_radiance(open_bytes(path));
}

std::unique_ptr<RadianceReader> open_panorama(const std::filesystem::path& path)
{
    return as_equirectangular(open_radiance(path), path.string());
}

RadianceImage read_radiance(const std::filesystem::path& path)
{
    return read_all_rows(*open_radiance(path));
}

RadianceImage read_radiance(const std::filesystem::path& path, Warnings& warnings)
{
    const std::unique_ptr<RadianceReader> reader = open_radiance(path);
    warnings.insert(warnings.end(), reader->warnings().begin(), reader->warnings().end());
    return read_all_rows(*reader);
}

RadianceImage decode_radiance(std::span<const std::uint8_t> bytes, const std::string& name)
{
    return read_all_rows(*open_radiance(open_bytes(bytes, name)));
}

CodeImage decode_codes(std::span<const std::uint8_t> bytes, const std::string& name, Warnings* warnings)
{
    const Content content = content_of(bytes);
    if (content == Content::png)
        return decode_png(bytes, name, warnings);
    if (content == Content::jpeg)
        return decode_jpeg(bytes, name, warnings);
    refuse(name, "is ", name_of(content), ", not PNG or JPEG");
}

CodeImage read_codes(const std::filesystem::path& path, Warnings* warnings)
{
    const std::unique_ptr<ByteSource> source = open_bytes(path);
    const Content content = content_of(*source);
    if (content != Content::png && content != Content::jpeg)
        refuse(source->name(), "is ", name_of(content), ", not PNG or JPEG");
    return decode_codes(read_all(*source), source->name(), warnings);
}

std::vector<float> read_coverage(const std::filesystem::path& path)
{
    std::unique_ptr<ByteSource> source = open_bytes(path);
    if (content_of(*source) != Content::exr)
        return {};
    const std::unique_ptr<RadianceReader> reader = open_exr_alpha(std::move(source));
    if (!reader)
        return {};
    const RadianceImage grey = read_all_rows(*reader);
    std::vector<float> coverage(grey.values.size() / 3);
    for (std::size_t i = 0; i < coverage.size(); ++i)
        coverage[i] = grey.values[3 * i];
    return coverage;
}

ImageInfo inspect(const std::filesystem::path& path, Warnings* warnings)
{
    std::unique_ptr<ByteSource> source = open_bytes(path);
    switch (content_of(*source)) {
    case Content::radiance:
        return inspect_radiance_hdr(*source);
    case Content::exr:
        return inspect_exr(*source);
    case Content::png:
        return inspect_png(read_all(*source), source->name());
    case Content::jpeg:
        return inspect_jpeg(read_all(*source), source->name(), warnings);
    case Content::other:
        break;
    }
    refuse(source->name(), "is not an image in a supported format");
}

void write_radiance(const RadianceImage& image, const std::filesystem::path& path, const Notes& notes)
{
    check_writable(image, image.values.size(), path);
    const FileKind kind = file_kind(path);
    if (kind != FileKind::exr && kind != FileKind::hdr)
        throw Error(Failure::usage, text(path.string(), ": radiance is written as .exr or .hdr"));
    check_can_write(path);
    write_file(path, kind == FileKind::exr ? encode_exr(image, notes) : encode_radiance_hdr(image, notes));
}

void write_codes(const CodeImage& image, const std::filesystem::path& path, const Notes& notes)
{
    if (image.bits != 8 && image.bits != 16)
        throw Error(Failure::usage, text(path.string(), ": cannot write ", image.bits, "-bit codes"));
    check_writable(image, image.bytes.size() / static_cast<std::size_t>(image.bits / 8), path);
    const FileKind kind = file_kind(path);
    if (kind != FileKind::png && kind != FileKind::jpeg)
        throw Error(Failure::usage, text(path.string(), ": codes are written as .png or .jpg"));
    if (kind == FileKind::jpeg && image.bits != 8)
        throw Error(Failure::usage, text(path.string(), ": a JPEG cannot hold ", image.bits, "-bit codes"));
    if (kind == FileKind::jpeg && std::max(image.width, image.height) > max_jpeg_side)
        throw Error(Failure::usage,
                    text(path.string(), ": a JPEG is at most ", max_jpeg_side, " pixels a side"));
    check_can_write(path);
    write_file(path, kind == FileKind::png ? encode_png(image, {}, notes) : encode_jpeg(image, {}, notes));
}

} // namespace lambent::image
