#include "image/jpeg.h"

#include "image/jpeg_markers.h"
#include "image/refuse.h"

#include <turbojpeg.h>

#include <new>
#include <type_traits>

namespace lambent::image {
namespace {

using Handle = std::unique_ptr<std::remove_pointer_t<tjhandle>, decltype(&tjDestroy)>;

Handle owned(tjhandle handle)
{
    if (!handle)
        throw std::bad_alloc();
    return {handle, &tjDestroy};
}

[[noreturn]] void refuse_with_reason(tjhandle handle, const std::string& name)
{
    refuse(name, "not a valid JPEG: ", printable(tjGetErrorStr2(handle), 200));
}

// A progressive file may revisit the whole picture in each of many tiny scans. Ten are usual; an
// encoder that sends each bit of each coefficient band on its own stays below a hundred.
void check_work(const JpegFrame& frame, const std::string& name)
{
    constexpr int max_scans = 100;
    constexpr std::int64_t max_visits = std::int64_t{1} << 32;
    const std::int64_t visits = std::int64_t{frame.width} * frame.height * frame.scans;
    if (frame.scans > max_scans || visits > max_visits)
        refuse(name, "its ", frame.scans, " scans of ", frame.width, "x", frame.height,
               " pixels are more work than a JPEG may ask for");
}

// The first component has a block of 8x8 for every 8x8 pixels at least, and with Huffman codes each block
// costs at least a bit. Arithmetic coding (processes 0xc9 and up) has no such bound; there a sixteenth is
// demanded, less than an encoder makes of a flat picture.
void check_length(const JpegFrame& frame, std::size_t length, const std::string& name)
{
    const std::int64_t blocks = std::int64_t{(frame.width + 7) / 8} * ((frame.height + 7) / 8);
    const std::int64_t least = blocks / (frame.process >= 0xc9 ? 128 : 8);
    if (least > static_cast<std::int64_t>(length))
        refuse(name, "a file of ", length, " bytes cannot hold the ", frame.width, "x", frame.height,
               " pixels its header claims");
}

JpegFrame checked_frame(std::span<const std::uint8_t> bytes, const std::string& name)
{
    const JpegFrame frame = read_jpeg_frame(bytes, name);
    check_size(name, frame.width, frame.height);
    if (frame.components == 4)
        refuse(name, "CMYK JPEGs are not supported; convert it to RGB");
    if (frame.bits != 8)
        refuse(name, frame.bits, "-bit JPEGs are not supported");
    check_work(frame, name);
    check_length(frame, bytes.size(), name);
    return frame;
}

struct Size {
    int width;
    int height;
};

CodeImage decode_scaled(tjhandle handle, std::span<const std::uint8_t> bytes, Size size,
                        const std::string& name)
{
    constexpr int flags = TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;
    CodeImage image{size.width, size.height, 4, 8, {}};
    image.bytes.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 4);
    if (tjDecompress2(handle, bytes.data(), static_cast<unsigned long>(bytes.size()), image.bytes.data(),
                      size.width, size.width * 4, size.height, TJPF_RGBA, flags) != 0)
        refuse_with_reason(handle, name);
    return image;
}

const char* process_name(int process)
{
    switch (process) {
    case 0xc0:
        return "baseline";
    case 0xc1:
        return "extended";
    case 0xc2:
        return "progressive";
    default:
        return process >= 0xc9 ? "arithmetic" : "lossless or hierarchical";
    }
}

} // namespace

bool is_jpeg(std::span<const std::uint8_t> bytes)
{
    return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

CodeImage decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name)
{
    const JpegFrame frame = checked_frame(bytes, name);
    const Handle handle = owned(tjInitDecompress());
    int width = 0, height = 0, subsampling = 0, colours = 0;
    if (tjDecompressHeader3(handle.get(), bytes.data(), static_cast<unsigned long>(bytes.size()), &width,
                            &height, &subsampling, &colours) != 0)
        refuse_with_reason(handle.get(), name);
    if (width != frame.width || height != frame.height || colours == TJCS_CMYK || colours == TJCS_YCCK)
        refuse(name, "not a valid JPEG: it contradicts itself");

    // A large picture is first decoded at an eighth of its size, so that memory is only taken for whole
    // files.
    constexpr std::int64_t large = std::int64_t{1} << 24;
    if (std::int64_t{width} * height > large)
        decode_scaled(handle.get(), bytes, {(width + 7) / 8, (height + 7) / 8}, name);
    return decode_scaled(handle.get(), bytes, {width, height}, name);
}

ImageInfo inspect_jpeg(std::span<const std::uint8_t> bytes, const std::string& name)
{
    const JpegFrame frame = checked_frame(bytes, name);
    return {"JPEG",
            text(frame.bits, "-bit ", frame.components == 1 ? "grey" : "colour", ", ",
                 process_name(frame.process)),
            frame.width, frame.height};
}

std::vector<std::uint8_t> encode_jpeg(const CodeImage& image, const JpegEffort& effort)
{
    const Handle handle = owned(tjInitCompress());
    unsigned char* buffer = nullptr;
    unsigned long length = 0;
    const int status = tjCompress2(
        handle.get(), image.bytes.data(), image.width, image.width * image.channels, image.height,
        image.channels == 4 ? TJPF_RGBX : TJPF_RGB, &buffer, &length, effort.halved ? TJSAMP_420 : TJSAMP_444,
        effort.quality, effort.halved ? TJFLAG_FASTDCT : TJFLAG_ACCURATEDCT);
    const std::unique_ptr<unsigned char, decltype(&tjFree)> owner(buffer, &tjFree);
    if (status != 0)
        throw std::bad_alloc();
    return {buffer, buffer + length};
}

} // namespace lambent::image
