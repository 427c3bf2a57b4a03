// The stored pixels of an OpenEXR file, as the library decodes them.
#pragma once

#include "image/openexr/openexr_channels.h"
#include "image/openexr/openexr_stream.h"

#include <memory>

namespace lambent::image {

class ExrRows {
public:
    virtual ~ExrRows() = default;

    /// `count` rows of the data window from row `first` on (in the file's coordinates), as interleaved RGB in the primaries
    /// of the file. What the library throws is its own.
    virtual void read(int first, int count, float* rgb) = 0;
};

/// `threads` as the library takes them. Luminance-chroma goes through half floats. The stream has to outlive the rows.
std::unique_ptr<ExrRows> open_exr_rows(ExrStream& stream, const ExrChoice& choice, const ExrPart& part,
                                       int threads);

} // namespace lambent::image
