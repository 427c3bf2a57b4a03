// What the readers of all formats give.
#pragma once

#include "base/error.h"
#include "image/image.h"

#include <string>

namespace lambent::image {

/// How an OpenEXR file says that its pixels are directions, in its attribute `envmap`.
enum class Projection { unknown, latitude_longitude, cube };

/// Row by row access to a Radiance .hdr or OpenEXR file, so that a 16384x8192 panorama never has to exist as
/// floats. Rows come top to bottom, whatever the order in the file. Values are as stored: NaN and infinity
/// included.
class RadianceReader {
public:
    virtual ~RadianceReader() = default;

    int width() const { return width_; }
    int height() const { return height_; }
    Projection projection() const { return projection_; }

    /// What had to be assumed, for the user to know: whole lines with the file's name.
    const Warnings& warnings() const { return warnings_; }

    /// The next `count` rows as interleaved RGB, width() * count * 3 floats. `count` at most the rows left.
    /// Calls for many rows are spread over threads: ask for 256 at a time where speed matters.
    /// Throws Error(bad_input) where the file ends early or contradicts itself.
    virtual void read_rows(int count, float* rgb) = 0;

protected:
    int width_ = 0;
    int height_ = 0;
    Projection projection_ = Projection::unknown;
    Warnings warnings_;
};

/// All rows of a reader that has given none yet.
RadianceImage read_all_rows(RadianceReader& reader);

/// What is in an image file, without decoding its pixels.
struct ImageInfo {
    std::string format; ///< "Radiance HDR", "OpenEXR", "PNG" or "JPEG"
    std::string detail; ///< compression, channels, bits, orientation: one short phrase
    int width = 0;
    int height = 0;
};

} // namespace lambent::image
