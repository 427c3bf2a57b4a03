// The skeleton of a JPEG file: what its frame header says and how many scans follow.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace lambent::image {

/// What can be known of a JPEG without decoding it (ITU-T T.81, annex B).
struct JpegFrame {
    int width = 0;
    int height = 0;
    int components = 0; ///< 1 grey, 3 colour, 4 CMYK or YCCK
    int bits = 0;       ///< of a sample
    int process = 0; ///< second byte of the frame marker: 0xc0 baseline, 0xc1 extended, 0xc2 progressive ...
    int scans = 0;
    bool ends_early = false; ///< it has a scan, but no end mark
};

/// Walks the markers from start to end. Throws Error(bad_input) when the bytes are no JPEG, end before
/// their first scan or hold no frame.
JpegFrame read_jpeg_frame(std::span<const std::uint8_t> bytes, const std::string& name);

} // namespace lambent::image
