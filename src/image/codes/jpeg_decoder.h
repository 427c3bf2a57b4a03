// Decodes one JPEG by libjpeg's own API. TurboJPEG's knows only some subsamplings, and after a complaint either stops
// or says nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace lambent::image {

/// What the decoder thinks of a file so far.
struct JpegVerdict {
    std::string error;     ///< why it stopped; empty: it did not
    std::string complaint; ///< the first thing that it mended; empty: none
    long complaints = 0;   ///< how many there were
    bool ends_early = false;
    bool out_of_memory = false;
};

class JpegDecoder {
public:
    /// `bytes` must outlive it. It stops at the first scan beyond `most_scans`.
    JpegDecoder(std::span<const std::uint8_t> bytes, int most_scans);
    JpegDecoder(const JpegDecoder&) = delete;
    JpegDecoder& operator=(const JpegDecoder&) = delete;
    ~JpegDecoder();

    /// Reads the header. `divisor`: 1, 2, 4 or 8, the whole picture as many times smaller. False: see verdict().
    bool open(int divisor);

    /// In pixels, once open: rounded up where a divisor does not divide.
    int width() const;
    int height() const;

    /// Whether it is grey, YCbCr or RGB, which alone can become RGBA.
    bool has_known_colours() const;

    /// Decodes to width() * height() RGBA codes. False: see verdict().
    bool read(std::uint8_t* rgba);

    JpegVerdict verdict() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lambent::image
