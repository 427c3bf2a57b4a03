// Finds the scanlines of a Radiance image in file order, before they are decoded.
#pragma once

#include "image/byte_source.h"
#include "image/radiance/radiance_header.h"
#include "image/radiance/radiance_scanline.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace lambent::image {

/// Consecutive encoded scanlines. Shares ownership of their bytes.
class ScanlineBatch {
public:
    int size() const { return static_cast<int>(scanlines_.size()); }

    /// Decodes the scanlines to RGB: size() * length * 3 floats.
    void to_rgb(int length, const ChannelScale& scale, float* rgb) const;

    /// Decodes the scanlines to RGBE and appends these size() * length pixels.
    void append_to(std::vector<Rgbe>& pixels, int length) const;

private:
    friend class ScanlineStream;

    struct Located {
        Scanline scanline;
        const std::uint8_t* bytes;
    };

    std::shared_ptr<const std::uint8_t[]> block_;
    std::vector<Located> scanlines_;
};

/// Reads a file in blocks of half a megabyte and a scanline and splits them into scanlines. Finding their ends
/// is much faster than decoding, so that one thread does it for several that decode.
class ScanlineStream {
public:
    ScanlineStream(std::unique_ptr<ByteSource> source, const RadianceHeader& header);

    /// The next scanlines: at least one, at most `most`, and no more than suit one task of a thread.
    /// Throws Error(bad_input).
    ScanlineBatch next(int most);

private:
    void refill();

    std::unique_ptr<ByteSource> source_;
    int length_;
    int found_ = 0;             ///< number of scanlines found so far
    std::uint64_t next_offset_; ///< of the end of the block in the file
    std::shared_ptr<std::uint8_t[]> block_;
    std::size_t begin_ = 0; ///< of the bytes in the block that are not yet split
    std::size_t end_ = 0;
};

} // namespace lambent::image
