// Decodes the stored pixels of an OpenEXR file with the library.
#pragma once

#include "image/openexr/openexr_channels.h"
#include "image/openexr/openexr_stream.h"

#include <memory>

namespace lambent::image {

class ExrRows {
public:
    virtual ~ExrRows() = default;

    /// Reads `count` rows of the data window from row `first` on (in the file's coordinates) as interleaved RGB in the
    /// file's primaries. Throws the library's exceptions.
    virtual void read(int first, int count, float* rgb) = 0;
};

/// Uses `threads` of the library's threads. Luminance-chroma is decoded to half floats. The stream must outlive the
/// rows.
std::unique_ptr<ExrRows> open_exr_rows(ExrStream& stream, const ExrChoice& choice, const ExrPart& part,
                                       int threads);

} // namespace lambent::image
