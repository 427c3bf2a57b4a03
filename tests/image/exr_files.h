// OpenEXR files made with the OpenEXR library itself.
#pragma once

#include "image/openexr/openexr.h"
#include "tests/image/temporary_folder.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace lambent::test {

inline std::vector<std::uint8_t> content_of(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// A value that differs for each pixel and channel and is exact in a half: small integers over 8.
inline float exr_value(int x, int y, std::size_t channel)
{
    return static_cast<float>((7 * x + 13 * y + 101 * static_cast<int>(channel)) % 2000) / 8.0f;
}

struct ExrRecipe {
    int width = 8;
    int height = 8;
    std::vector<std::string> channels = {"R", "G", "B"};
    Imf::PixelType type = Imf::FLOAT;
    Imf::Compression compression = Imf::ZIP_COMPRESSION;
    Imf::LineOrder order = Imf::INCREASING_Y;
    int min_x = 0;
    int min_y = 0;
    int tile = 0; ///< side of a tile; 0 for scanlines
    Imf::LevelMode levels = Imf::ONE_LEVEL;
    std::optional<Imath::Box2i> display = {}; ///< none: the data window
    std::function<void(Imf::Header&)> attributes = {};
    std::function<float(int x, int y, std::size_t channel)> value = exr_value;
};

/// The pixel at (x, y) from the upper left of the data window has value(x, y, channel), cut to an integer in uint channels.
inline std::vector<std::uint8_t> make_exr(const ExrRecipe& recipe)
{
    const TemporaryFolder folder;
    const std::string path = (folder / "made.exr").string();
    const Imath::Box2i window({recipe.min_x, recipe.min_y},
                              {recipe.min_x + recipe.width - 1, recipe.min_y + recipe.height - 1});
    Imf::Header header(recipe.display.value_or(window), window, 1, {0, 0}, 1, recipe.order,
                       recipe.compression);
    if (recipe.attributes)
        recipe.attributes(header);
    const auto count = static_cast<std::size_t>(recipe.width) * static_cast<std::size_t>(recipe.height);
    std::vector<std::vector<std::uint32_t>> memory(recipe.channels.size(), std::vector<std::uint32_t>(count));
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < recipe.channels.size(); ++c) {
        header.channels().insert(recipe.channels[c], Imf::Channel(recipe.type));
        for (std::size_t i = 0; i < count; ++i) {
            const float value =
                recipe.value(static_cast<int>(i) % recipe.width, static_cast<int>(i) / recipe.width, c);
            if (recipe.type == Imf::FLOAT)
                reinterpret_cast<float&>(memory[c][i]) = value;
            else if (recipe.type == Imf::HALF)
                reinterpret_cast<half&>(memory[c][i]) = half(value);
            else
                memory[c][i] = static_cast<std::uint32_t>(value);
        }
        frame.insert(recipe.channels[c], Imf::Slice::Make(recipe.type, memory[c].data(), window, 4,
                                                          4 * static_cast<std::size_t>(recipe.width)));
    }
    if (recipe.tile == 0) {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(recipe.height);
    } else {
        header.setTileDescription(Imf::TileDescription(static_cast<unsigned>(recipe.tile),
                                                       static_cast<unsigned>(recipe.tile), recipe.levels));
        Imf::TiledOutputFile file(path.c_str(), header);
        file.setFrameBuffer(frame);
        // Coarser levels get the upper left part of the same values: they must not be what is read.
        for (int level = 0; level < file.numLevels(); ++level)
            file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
    }
    return content_of(path);
}

/// The file's pixels, `portion` rows at a time.
inline image::RadianceImage read_exr(const std::vector<std::uint8_t>& bytes, int portion = 1 << 16)
{
    const auto reader = image::open_exr(image::open_bytes(bytes, "test.exr"));
    image::RadianceImage image{reader->width(), reader->height(), 3, {}};
    image.values.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3);
    for (int y = 0; y < image.height; y += portion)
        reader->read_rows(std::min(portion, image.height - y), image.pixel(0, y));
    return image;
}

} // namespace lambent::test
