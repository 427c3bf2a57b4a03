#include "image/codes/jpeg_markers.h"

#include "image/refuse.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace lambent::image {
namespace {

constexpr int start_of_image = 0xd8;
constexpr int end_of_image = 0xd9;
constexpr int start_of_scan = 0xda;

// Whether the marker is one of SOF0 to SOF15. Three codes between them (DHT, JPG, DAC) are not.
bool is_frame(int marker)
{
    return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

// Whether the marker has no segment: the restarts and TEM.
bool is_bare(int marker)
{
    return (marker >= 0xd0 && marker <= 0xd7) || marker == 0x01;
}

// Thrown on reading beyond the last byte.
struct EndOfFile {};

struct Walk {
    std::span<const std::uint8_t> bytes;
    const std::string& name;
    std::size_t at = 0;

    int byte(std::size_t index) const
    {
        if (index >= bytes.size())
            throw EndOfFile();
        return bytes[index];
    }
    int word(std::size_t index) const { return byte(index) * 256 + byte(index + 1); }

    // Moves past the next marker and returns it. Bytes before it are entropy-coded data, in which 0 follows every
    // 0xff, or fill bytes.
    int next_marker()
    {
        for (;;) {
            const void* found =
                at < bytes.size() ? std::memchr(bytes.data() + at, 0xff, bytes.size() - at) : nullptr;
            at = found ? static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - bytes.data()) + 1
                       : bytes.size();
            const int marker = byte(at);
            if (marker != 0 && marker != 0xff) {
                ++at;
                return marker;
            }
        }
    }
};

void read_frame_header(const Walk& walk, int marker, JpegFrame& frame)
{
    if (frame.process != 0)
        refuse(walk.name, "not a valid JPEG: it has two frame headers");
    frame.process = marker;
    frame.bits = walk.byte(walk.at + 2);
    frame.height = walk.word(walk.at + 3);
    frame.width = walk.word(walk.at + 5);
    frame.components = walk.byte(walk.at + 7);
}

void read_segments(Walk& walk, JpegFrame& frame)
{
    if (walk.byte(0) != 0xff || walk.byte(1) != start_of_image)
        refuse(walk.name, "not a JPEG");
    walk.at = 2;
    for (int marker = walk.next_marker(); marker != end_of_image; marker = walk.next_marker()) {
        if (is_bare(marker))
            continue;
        const int length = walk.word(walk.at);
        if (length < 2)
            refuse(walk.name, "not a valid JPEG: the segment at byte ", walk.at, " has length ", length);
        if (is_frame(marker))
            read_frame_header(walk, marker, frame);
        if (marker == start_of_scan)
            ++frame.scans;
        walk.at += static_cast<std::size_t>(length);
    }
}

} // namespace

JpegFrame read_jpeg_frame(std::span<const std::uint8_t> bytes, const std::string& name)
{
    Walk walk{bytes, name};
    JpegFrame frame;
    try {
        read_segments(walk, frame);
    } catch (const EndOfFile&) {
        if (frame.scans == 0)
            refuse(name, "not a valid JPEG: it ends after ", bytes.size(), " bytes, before its end marker");
        frame.ends_early = true;
    }
    if (frame.process == 0 || frame.scans == 0)
        refuse(name, "not a valid JPEG: it holds no image");
    return frame;
}

} // namespace lambent::image
