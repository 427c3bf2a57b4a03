// What the header of an OpenEXR file says of one image, and whether that can be true.
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

/// Pixels from (min_x, min_y) on.
struct ExrWindow {
    int min_x = 0, min_y = 0, width = 0, height = 0;

    bool operator==(const ExrWindow&) const = default;
};

struct ExrPart {
    std::string type; ///< empty where a file of one part leaves it out
    int min_x = 0;    ///< the data window: the stored pixels
    int min_y = 0;
    int width = 0;
    int height = 0;
    int compression = 0; ///< 0 none, 1 RLE, 2 ZIPS, 3 ZIP, 4 PIZ, 5 PXR24, 6 B44, 7 B44A, 8 DWAA, 9 DWAB
    bool tiled = false;
    bool deep = false; ///< any number of samples a pixel
    int tile_width = 0;
    int tile_height = 0;
    std::vector<ExrChannel> channels;
    ExrWindow display; ///< the picture, of which the data window may have too little or too much
    std::optional<Primaries> primaries;          ///< those that to_rec709() takes
    Projection projection = Projection::unknown; ///< one that the data window's size allows
    std::vector<std::string> doubts; ///< attributes that make no sense, each as a line for a warning

    ExrWindow data_window() const { return {min_x, min_y, width, height}; }
    /// Rows that are stored, and so decoded, together.
    int rows_per_chunk() const;
    /// Memory for those rows once decoded, at most.
    std::uint64_t decoded_chunk_bytes() const;
    /// "ZIP", "no compression", ...
    const char* compression_name() const;
};

/// Number of values that `compression` may have.
inline constexpr int exr_compressions = 10;

/// Refuses a part that a file of that many bytes cannot hold, however well compressed: an empty claim of a
/// large image must not cost memory. `name` is used in the message.
void check_exr_part(const ExrPart& part, std::uint64_t file_bytes, const std::string& name);

} // namespace lambent::image
