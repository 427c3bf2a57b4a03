// The scanlines of a Radiance picture in file order, found ahead of being decoded.
#pragma once

#include "image/byte_source.h"
#include "image/radiance/radiance_header.h"
#include "image/radiance/radiance_scanline.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace lambent::image {

/// Some scanlines that follow each other, still encoded. Keeps its bytes alive.
class ScanlineBatch {
public:
    int size() const { return static_cast<int>(scanlines_.size()); }

    /// Decodes one scanline after the other as RGB: size() * length * 3 floats.
    void to_rgb(int length, const ChannelScale& scale, float* rgb) const;

    /// Appends them as they are stored: size() * length pixels.
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

/// Reads a file block by block (half a megabyte and a scanline) and cuts it into scanlines. Finding where
/// they end is much faster than decoding them, so that one thread finds them for several that decode.
class ScanlineStream {
public:
    ScanlineStream(std::unique_ptr<ByteSource> source, const RadianceHeader& header);

    /// The next scanlines: at least one, at most `most`, and no more than are good for one piece of work.
    /// Throws Error(bad_input).
    ScanlineBatch next(int most);

private:
    void refill();

    std::unique_ptr<ByteSource> source_;
    int length_;
    int found_ = 0;             ///< scanlines so far
    std::uint64_t next_offset_; ///< of the file behind the block
    std::shared_ptr<std::uint8_t[]> block_;
    std::size_t begin_ = 0; ///< of what is not yet cut, in the block
    std::size_t end_ = 0;
};

} // namespace lambent::image
