// A drawn picture as a file.
#pragma once

#include "display/display.h"
#include "image/image.h"
#include "image/notes.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace lambent::cli {

/// Throws Error(usage) if the name's extension is none of .png .jpg .jpeg .exr .hdr, Error(cannot_write) if the file
/// evidently cannot be written. Called before the work.
void check_picture_file(const std::filesystem::path& path);

/// .exr and .hdr: linear light as it is. .png and .jpg: as displayed; with `transparent`, a PNG gets the picture's
/// coverage as alpha, and colours that are not multiplied by it.
/// The file carries the notes.
void write_picture(const image::RadianceImage& picture, const display::Settings& display, bool transparent,
                   const std::filesystem::path& path, const image::Notes& notes = {});

/// A picture as displayed; `transparent` as above: RGBA codes.
image::CodeImage picture_codes(const image::RadianceImage& picture, const display::Settings& display,
                               bool transparent);

/// The bytes that write_picture writes into a .png or .jpg. Throws Error(usage) for any other extension.
std::vector<std::uint8_t> picture_bytes(const image::RadianceImage& picture, const display::Settings& display,
                                        bool transparent, const std::filesystem::path& path,
                                        const image::Notes& notes = {});

} // namespace lambent::cli
