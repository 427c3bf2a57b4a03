// The header of a Radiance image ("Radiance File Formats", the picture section; Ward, LBNL).
#pragma once

#include "image/radiance/rgbe.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace lambent::image {

/// Orientation of the file's scanlines in the image.
struct ScanlineOrder {
    bool columns = false;      ///< scanlines are columns
    bool right_first = false;  ///< x runs from right to left (-X)
    bool bottom_first = false; ///< y runs from bottom to top (+Y)

    /// Rows from the top, pixels from the left, as in nearly every file.
    bool usual() const { return !columns && !right_first && !bottom_first; }
};

struct RadianceHeader {
    int width = 0;
    int height = 0;
    ScanlineOrder order;
    std::string resolution;      ///< the resolution line as stored, "-Y 1024 +X 2048"
    ChannelScale scale{1, 1, 1}; ///< from stored values to radiance: 1 / (all EXPOSUREs and COLORCORRs)
    std::size_t length = 0;      ///< bytes before the first scanline

    int scanlines() const { return order.columns ? width : height; }
    int scanline_length() const { return order.columns ? height : width; }
};

/// Length in bytes of the longest header that is read.
inline constexpr std::size_t max_radiance_header = std::size_t{1} << 18;

/// Whether the bytes begin with the signature of Radiance images, "#?".
bool is_radiance(std::span<const std::uint8_t> bytes);

/// Reads the header at the start of `bytes`, which hold the first max_radiance_header bytes of the file or
/// all of it. FORMAT, if given, must be 32-bit_rle_rgbe; VIEW, PRIMARIES, PIXASPECT and other lines are
/// ignored. Throws Error(bad_input).
RadianceHeader read_radiance_header(std::span<const std::uint8_t> bytes, const std::string& name);

} // namespace lambent::image
