// The interface of the readers of all formats.
#pragma once

#include "base/error.h"
#include "image/image.h"

#include <string>

namespace lambent::image {

/// Mapping from pixels to directions, as given by the attribute `envmap` of OpenEXR files.
enum class Projection { unknown, latitude_longitude, cube };

/// Reads a Radiance .hdr or OpenEXR file row by row, so that a 16384x8192 panorama never has to be in memory as
/// floats. Rows come from top to bottom, whatever their order in the file. Values are as stored, NaN and
/// infinity included.
class RadianceReader {
public:
    virtual ~RadianceReader() = default;

    int width() const { return width_; }
    int height() const { return height_; }
    Projection projection() const { return projection_; }

    /// Assumptions that the user should know of, one line each with the file's name.
    const Warnings& warnings() const { return warnings_; }

    /// Reads the next `count` rows, at most those left, as interleaved RGB: width() * count * 3 floats. Calls
    /// for many rows use several threads: 256 rows at a time are fast.
    /// Throws Error(bad_input) if the file ends early or is inconsistent.
    virtual void read_rows(int count, float* rgb) = 0;

protected:
    int width_ = 0;
    int height_ = 0;
    Projection projection_ = Projection::unknown;
    Warnings warnings_;
};

/// Reads all rows from a reader of which none has been read.
RadianceImage read_all_rows(RadianceReader& reader);

/// Format and size of an image file, found without decoding its pixels.
struct ImageInfo {
    std::string format; ///< "Radiance HDR", "OpenEXR", "PNG" or "JPEG"
    std::string detail; ///< compression, channels, bits, orientation: one short phrase
    int width = 0;
    int height = 0;
};

} // namespace lambent::image
