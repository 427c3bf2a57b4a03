#include "image/codes/jpeg.h"

#include "image/codes/jpeg_decoder.h"
#include "image/codes/jpeg_markers.h"
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

[[noreturn]] void refuse_for(const JpegStatus& status, const std::string& name)
{
    if (status.out_of_memory)
        throw std::bad_alloc();
    refuse(name, "not a valid JPEG: ", printable(status.error, 200));
}

// Ten scans are usual; an encoder with a scan for each bit of each band of coefficients stays below this.
constexpr int max_scans = 100;

// Limits the time to decode a progressive file, in which each of many tiny scans may visit the whole image.
void check_work(const JpegFrame& frame, const std::string& name)
{
    constexpr std::int64_t max_visits = std::int64_t{1} << 32;
    const std::int64_t visits = std::int64_t{frame.width} * frame.height * frame.scans;
    if (frame.scans > max_scans || visits > max_visits)
        refuse(name, "its ", frame.scans, " scans of ", frame.width, "x", frame.height,
               " pixels exceed the limit on decoding work");
}

// The first component has at least a block for every 8x8 pixels, and with Huffman codes a block takes at
// least a bit. Arithmetic coding (processes 0xc9 and up) has no such bound; a sixteenth of a bit is required
// instead, less than an encoder needs for an image of a single colour.
void check_length(const JpegFrame& frame, std::size_t length, const std::string& name)
{
    const std::int64_t blocks = std::int64_t{(frame.width + 7) / 8} * ((frame.height + 7) / 8);
    const std::int64_t least = blocks / (frame.process >= 0xc9 ? 128 : 8);
    if (least > static_cast<std::int64_t>(length))
        refuse(name, "a file of ", length, " bytes cannot hold the ", frame.width, "x", frame.height,
               " pixels its header claims");
}

// Reports damage to a file that can be read nevertheless: a warning, or an error if there are no `warnings`.
void report_damage(const std::string& damage, const std::string& name, Warnings* warnings)
{
    if (warnings == nullptr)
        refuse(name, "not a valid JPEG: ", damage);
    warnings->push_back(text(name, ": damaged JPEG: ", damage));
}

std::string early_end(std::size_t length)
{
    return text("it ends after ", length, " bytes, before its end marker");
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

void open(JpegDecoder& decoder, int divisor, const JpegFrame& frame, const std::string& name)
{
    if (!decoder.open(divisor))
        refuse_for(decoder.status(), name);
    if (decoder.width() != (frame.width + divisor - 1) / divisor ||
        decoder.height() != (frame.height + divisor - 1) / divisor)
        refuse(name, "not a valid JPEG: its size contradicts its frame header");
    if (!decoder.has_known_colours())
        refuse(name, "its colour space is not supported");
}

std::vector<std::uint8_t> read(JpegDecoder& decoder, const std::string& name)
{
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(decoder.width()) *
                                   static_cast<std::size_t>(decoder.height()) * 4);
    if (!decoder.read(rgba.data()))
        refuse_for(decoder.status(), name);
    return rgba;
}

// Decodes a large image at an eighth of its size first, so that full memory is only allocated for complete files.
void check_whole(std::span<const std::uint8_t> bytes, const JpegFrame& frame, const std::string& name)
{
    constexpr std::int64_t large = std::int64_t{1} << 24;
    if (std::int64_t{frame.width} * frame.height <= large)
        return;
    JpegDecoder decoder(bytes, max_scans);
    open(decoder, 8, frame, name);
    read(decoder, name);
    if (decoder.status().ends_early)
        refuse(name, "not a valid JPEG: ", early_end(bytes.size()));
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

// COM segments go between the JFIF header, which must come first, and everything else: JFIF 1.02, page 5.
std::vector<std::uint8_t> with_comments(std::span<const std::uint8_t> jpeg, const Notes& notes)
{
    constexpr std::size_t most = 65533;
    const std::size_t header = jpeg.size() > 6 && jpeg[2] == 0xff && jpeg[3] == 0xe0
                                   ? std::size_t{4} + (std::size_t{jpeg[4]} << 8 | jpeg[5])
                                   : 2;
    std::vector<std::uint8_t> bytes(jpeg.begin(), jpeg.begin() + static_cast<std::ptrdiff_t>(header));
    for (const Note& note : notes) {
        const std::string comment = text(note.key, ": ", note.value).substr(0, most);
        const std::size_t length = comment.size() + 2;
        for (const std::size_t byte : {std::size_t{0xff}, std::size_t{0xfe}, length >> 8, length & 255u})
            bytes.push_back(static_cast<std::uint8_t>(byte));
        bytes.insert(bytes.end(), comment.begin(), comment.end());
    }
    bytes.insert(bytes.end(), jpeg.begin() + static_cast<std::ptrdiff_t>(header), jpeg.end());
    return bytes;
}

} // namespace

bool is_jpeg(std::span<const std::uint8_t> bytes)
{
    return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

CodeImage decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name, Warnings* warnings)
{
    const JpegFrame frame = checked_frame(bytes, name);
    check_whole(bytes, frame, name);
    JpegDecoder decoder(bytes, max_scans);
    open(decoder, 1, frame, name);
    CodeImage image{frame.width, frame.height, 4, 8, read(decoder, name)};
    const JpegStatus status = decoder.status();
    if (frame.ends_early || status.ends_early)
        report_damage(early_end(bytes.size()), name, warnings);
    else if (status.warnings > 0)
        report_damage(text(printable(status.warning, 200),
                           status.warnings > 1 ? text(" (and ", status.warnings - 1, " more)") : ""),
                      name, warnings);
    return image;
}

ImageInfo inspect_jpeg(std::span<const std::uint8_t> bytes, const std::string& name, Warnings* warnings)
{
    const JpegFrame frame = checked_frame(bytes, name);
    if (frame.ends_early)
        report_damage(early_end(bytes.size()), name, warnings);
    return {"JPEG",
            text(frame.bits, "-bit ", frame.components == 1 ? "grey" : "colour", ", ",
                 process_name(frame.process)),
            frame.width, frame.height};
}

std::vector<std::uint8_t> encode_jpeg(const CodeImage& image, const JpegEffort& effort, const Notes& notes)
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
    return with_comments({buffer, length}, notes);
}

} // namespace lambent::image
