// Decodes a JPEG with libjpeg's API. TurboJPEG's API supports only some subsamplings, and on a warning it either stops
// or ignores it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace lambent::image {

/// Errors and warnings of the decoder so far.
struct JpegStatus {
    std::string error;   ///< why it stopped; empty if it did not
    std::string warning; ///< the first warning; empty if there is none
    long warnings = 0;   ///< number of warnings
    bool ends_early = false;
    bool out_of_memory = false;
};

class JpegDecoder {
public:
    /// `bytes` must outlive the decoder. Decoding stops at the first scan after `most_scans`.
    JpegDecoder(std::span<const std::uint8_t> bytes, int most_scans);
    JpegDecoder(const JpegDecoder&) = delete;
    JpegDecoder& operator=(const JpegDecoder&) = delete;
    ~JpegDecoder();

    /// Reads the header. The image is decoded `divisor` times smaller: 1, 2, 4 or 8. Returns false on an error, which
    /// status() describes.
    bool open(int divisor);

    /// Size in pixels, valid after open(): that of the file over the divisor, rounded up.
    int width() const;
    int height() const;

    /// Whether the file is grey, YCbCr or RGB, which can be converted to RGBA.
    bool has_known_colours() const;

    /// Decodes to width() * height() RGBA codes. Returns false on an error, which status() describes.
    bool read(std::uint8_t* rgba);

    JpegStatus status() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lambent::image
