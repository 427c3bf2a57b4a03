// Reads and writes image files. Reading recognizes the format by content, writing by the file's name.
#pragma once

#include "base/error.h"
#include "image/image.h"
#include "image/notes.h"
#include "image/reader.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace lambent::image {

/// Opens a Radiance HDR or OpenEXR file. Throws Error(bad_input).
std::unique_ptr<RadianceReader> open_radiance(const std::filesystem::path& path);

/// The same, with OpenEXR environment maps converted to equirectangular panoramas: rows from +Y down, +X in the middle
/// column, +Z a quarter of the width to its right (image/openexr/openexr_map.h). Throws Error(bad_input).
std::unique_ptr<RadianceReader> open_panorama(const std::filesystem::path& path);

/// Reads a whole Radiance HDR or OpenEXR file as RGB. Throws Error(bad_input).
RadianceImage read_radiance(const std::filesystem::path& path);
RadianceImage read_radiance(const std::filesystem::path& path, Warnings& warnings);

/// The same for bytes in memory; `name` is used in messages. Throws Error(bad_input).
RadianceImage decode_radiance(std::span<const std::uint8_t> bytes, const std::string& name);

/// Decodes a PNG or JPEG in memory to RGBA codes of 8 or (PNG) 16 bits. `name` is used in messages. A damaged file that
/// can be decoded nevertheless is reported in `warnings`, or refused if there are none (image/codes/png.h, jpeg.h).
/// Throws Error(bad_input); safe for untrusted bytes.
CodeImage decode_codes(std::span<const std::uint8_t> bytes, const std::string& name,
                       Warnings* warnings = nullptr);

/// Reads a PNG or JPEG file as decode_codes. Throws Error(bad_input).
CodeImage read_codes(const std::filesystem::path& path, Warnings* warnings = nullptr);

/// The coverage of each pixel by surfaces, rows from the top: the alpha channel of an OpenEXR file, as stored. Empty for
/// files without one and for other formats. Throws Error(bad_input).
std::vector<float> read_coverage(const std::filesystem::path& path);

/// Formats of output files.
enum class FileKind { png, jpeg, exr, hdr, unknown };

/// The format of a name by its extension, in any case: .png, .jpg, .jpeg, .exr or .hdr.
FileKind file_kind(const std::filesystem::path& path);

/// Writes radiance as .exr (RGB or RGBA, 32-bit float, ZIP) or .hdr (planes with run-length encoding; coverage is
/// dropped, negative values become 0). Throws Error(cannot_write), or Error(usage) for another extension.
void write_radiance(const RadianceImage& image, const std::filesystem::path& path, const Notes& notes = {});

/// Writes codes as .png (8 or 16 bit) or .jpg (8 bit, quality 95, 4:4:4, alpha dropped).
/// Throws Error(cannot_write), or Error(usage) for another extension or a 16-bit JPEG.
void write_codes(const CodeImage& image, const std::filesystem::path& path, const Notes& notes = {});

/// Format and size of an image file. Damage is reported as by decode_codes, as far as it shows without decoding. Throws
/// Error(bad_input).
ImageInfo inspect(const std::filesystem::path& path, Warnings* warnings = nullptr);

} // namespace lambent::image
