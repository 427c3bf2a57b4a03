// Images from and to files. The format read is told from the content, the format written from the name.
#pragma once

#include "base/error.h"
#include "image/image.h"
#include "image/reader.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace lambent::image {

/// Opens a .hdr or .exr by content. Throws Error(bad_input).
std::unique_ptr<RadianceReader> open_radiance(const std::filesystem::path& path);

/// The same, environment maps of OpenEXR brought to an equirectangular panorama: rows from +Y down, the middle column +X, +Z
/// a quarter to its right (image/openexr/openexr_map.h). Throws Error(bad_input).
std::unique_ptr<RadianceReader> open_panorama(const std::filesystem::path& path);

/// The whole of a .hdr or .exr as RGB. Throws Error(bad_input).
RadianceImage read_radiance(const std::filesystem::path& path);
RadianceImage read_radiance(const std::filesystem::path& path, Warnings& warnings);

/// The same of bytes in memory; `name` is used in messages. Throws Error(bad_input).
RadianceImage decode_radiance(std::span<const std::uint8_t> bytes, const std::string& name);

/// A PNG or JPEG held in memory, as RGBA codes, 8 or (PNG) 16 bits. `name` is used in messages. What is damaged but can be
/// shown is told to `warnings`, or without them refused (image/codes/png.h, image/codes/jpeg.h).
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

/// `warnings` as decode_codes, as far as it is seen. Throws Error(bad_input).
ImageInfo inspect(const std::filesystem::path& path, Warnings* warnings = nullptr);

} // namespace lambent::image
