// The header of one part (image) of an OpenEXR file, and a check whether the file can contain that image.
#pragma once

#include "image/image.h"
#include "image/reader.h"
#include "image/openexr/primaries.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lambent::image {

enum class ExrPixel { uint32 = 0, half = 1, float32 = 2 };

struct ExrChannel {
    std::string name; ///< with its layer: "R", "diffuse.R"
    ExrPixel pixel = ExrPixel::half;
    int x_sampling = 1;
    int y_sampling = 1;
};

/// A rectangle of pixels with the top left corner (min_x, min_y).
struct ExrWindow {
    int min_x = 0, min_y = 0, width = 0, height = 0;

    bool operator==(const ExrWindow&) const = default;
};

struct ExrPart {
    std::string type; ///< empty if a file with a single part omits it
    int min_x = 0;    ///< the data window: the stored pixels
    int min_y = 0;
    int width = 0;
    int height = 0;
    int compression = 0; ///< 0 none, 1 RLE, 2 ZIPS, 3 ZIP, 4 PIZ, 5 PXR24, 6 B44, 7 B44A, 8 DWAA, 9 DWAB
    bool tiled = false;
    bool deep = false; ///< has any number of samples per pixel
    int tile_width = 0;
    int tile_height = 0;
    std::vector<ExrChannel> channels;
    ExrWindow display;                  ///< the image; the data window may be smaller or extend beyond it
    std::optional<Primaries> primaries; ///< only if to_rec709() accepts them
    Projection projection = Projection::unknown; ///< a cube only if the data window's size is that of one
    std::vector<std::string> warnings;           ///< warnings of invalid attributes, one line each

    ExrWindow data_window() const { return {min_x, min_y, width, height}; }
    /// Number of rows that are stored, and therefore decoded, together.
    int rows_per_chunk() const;
    /// Upper bound on the memory of those rows when decoded.
    std::uint64_t decoded_chunk_bytes() const;
    /// "ZIP", "no compression", ...
    const char* compression_name() const;
};

/// Number of values of ExrPart::compression.
inline constexpr int exr_compressions = 10;

/// Refuses a part that a file of `file_bytes` bytes cannot contain at any compression, so that a wrong image size
/// does not make the reader allocate memory. `name` is used in the message.
void check_exr_part(const ExrPart& part, std::uint64_t file_bytes, const std::string& name);

} // namespace lambent::image
