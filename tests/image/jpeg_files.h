// JPEG files: one made by hand after ITU-T T.81, others by the library.
#pragma once

#include "tests/image/bytes.h"

#include <turbojpeg.h>

#include <cstdint>

namespace lambent::test {

extern const Bytes start_of_image, end_of_image;

/// One component, all of whose blocks are 0 (code), 1000 (the difference 8), 0 (end of block), and ones to
/// fill.
extern const Bytes scan;

/// Quantisation by 8, and codes of one bit each: difference of four bits; end of block.
Bytes table_segments();

Bytes frame(int width, int height, std::uint8_t process = 0xc0, std::uint8_t bits = 8);

/// 8x8 grey pixels of 128 + 8 * 8 / 8 (difference times quantisation over the transform's 8).
Bytes tiny_jpeg();

struct Encoding {
    int format = TJPF_RGB;
    int subsampling = TJSAMP_444;
    int flags = 0;
};

/// A smooth picture, 40 + 2 x + 3 y + 20 c, by TurboJPEG.
Bytes encode(int width, int height, const Encoding& encoding);

/// Samples of luminance for each of colour.
struct Sampling {
    int across = 1, down = 1;
};

/// A picture whose colour changes along both axes.
int slope(int x, int y, int channel);

/// That picture, by libjpeg.
Bytes encode_sampled(int width, int height, const Sampling& sampling);

} // namespace lambent::test
