// Images from and to files. The format read is told from the content, the format written from the name.
#pragma once

#include "base/error.h"
#include "image/image.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
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

/// Opens a .hdr or .exr by content. Throws Error(bad_input).
std::unique_ptr<RadianceReader> open_radiance(const std::filesystem::path& path);

/// The same, environment maps of OpenEXR brought to an equirectangular panorama: rows from +Y down, the middle column +X, +Z
/// a quarter to its right (image/openexr_map.h). Throws Error(bad_input).
std::unique_ptr<RadianceReader> open_panorama(const std::filesystem::path& path);

/// All rows of a reader that has given none yet.
RadianceImage read_all_rows(RadianceReader& reader);

/// The whole of a .hdr or .exr as RGB. Throws Error(bad_input).
RadianceImage read_radiance(const std::filesystem::path& path);
RadianceImage read_radiance(const std::filesystem::path& path, Warnings& warnings);

/// The same of bytes in memory; `name` is used in messages. Throws Error(bad_input).
RadianceImage decode_radiance(std::span<const std::uint8_t> bytes, const std::string& name);

/// A PNG or JPEG held in memory, as RGBA codes, 8 or (PNG) 16 bits. `name` is used in messages. What is damaged but can be
/// shown is told to `warnings`, or without them refused (image/png.h, image/jpeg.h).
/// Throws Error(bad_input); safe for untrusted bytes.
CodeImage decode_codes(std::span<const std::uint8_t> bytes, const std::string& name,
                       Warnings* warnings = nullptr);

/// A PNG or JPEG file, as decode_codes. Throws Error(bad_input).
CodeImage read_codes(const std::filesystem::path& path, Warnings* warnings = nullptr);

/// Kinds of output file, by extension.
enum class FileKind { png, jpeg, exr, hdr, unknown };

/// The kind a name asks for: .png .jpg .jpeg .exr .hdr, any case.
FileKind file_kind(const std::filesystem::path& path);

/// Writes light as .exr (RGB or RGBA, 32-bit float, ZIP) or .hdr (new RLE; coverage is dropped, negative
/// becomes 0). Throws Error(cannot_write), or Error(usage) for another extension.
void write_radiance(const RadianceImage& image, const std::filesystem::path& path);

/// Writes codes as .png (8 or 16 bit) or .jpg (8 bit, quality 95, 4:4:4, alpha dropped).
/// Throws Error(cannot_write), or Error(usage) for another extension or 16 bits into a JPEG.
void write_codes(const CodeImage& image, const std::filesystem::path& path);

/// What is in an image file, without decoding its pixels.
struct ImageInfo {
    std::string format; ///< "Radiance HDR", "OpenEXR", "PNG" or "JPEG"
    std::string detail; ///< compression, channels, bits, orientation: one short phrase
    int width = 0;
    int height = 0;
};

/// `warnings` as decode_codes, as far as it is seen. Throws Error(bad_input).
ImageInfo inspect(const std::filesystem::path& path, Warnings* warnings = nullptr);

} // namespace lambent::image
