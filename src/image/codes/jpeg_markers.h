// Reads the markers of a JPEG file: its frame header and the number of its scans.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace lambent::image {

/// The properties of a JPEG that are known without decoding it (ITU-T T.81, annex B).
struct JpegFrame {
    int width = 0;
    int height = 0;
    int components = 0; ///< 1 grey, 3 colour, 4 CMYK or YCCK
    int bits = 0;       ///< per sample
    int process = 0; ///< second byte of the frame marker: 0xc0 baseline, 0xc1 extended, 0xc2 progressive ...
    int scans = 0;
    bool ends_early = false; ///< has a scan but no end marker
};

/// Reads all markers. Throws Error(bad_input) if the bytes are no JPEG, end before the first scan or have no
/// frame header.
JpegFrame read_jpeg_frame(std::span<const std::uint8_t> bytes, const std::string& name);

} // namespace lambent::image
