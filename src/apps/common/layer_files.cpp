#include "apps/common/layer_files.h"

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "image/files/image_io.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

namespace lambent::cli {
namespace {

using draw::Layer;

// Values of layers are premultiplied by coverage, those of their .png are not.
float uncovered(float value, float coverage)
{
    return coverage > 0.0f ? value / coverage : 0.0f;
}

struct Range {
    float low = std::numeric_limits<float>::infinity(), high = 0.0f;
};

Range depth_range(const image::RadianceImage& image)
{
    Range range;
    for (std::size_t i = 0; i < image.values.size(); i += 4)
        if (image.values[i + 3] > 0.0f) {
            const float depth = image.values[i] / image.values[i + 3];
            range = {std::min(range.low, depth), std::max(range.high, depth)};
        }
    return range;
}

// Maps a value to [0, 1] for the .png of this kind of layer.
float shown(Layer::Kind kind, float value, const Range& depths)
{
    switch (kind) {
    case Layer::Kind::normal:
        return value * 0.5f + 0.5f;
    case Layer::Kind::exponent:
        return std::log10(std::max(value, 0.01f) * 100.0f) / 8.0f; // 0.01 to 1e6
    case Layer::Kind::depth:
        return depths.high > depths.low ? 1.0f - 0.9f * (value - depths.low) / (depths.high - depths.low)
                                        : 1.0f;
    default:
        return value;
    }
}

} // namespace

image::CodeImage layer_picture(const Layer& layer, const display::Settings& display)
{
    if (layer.kind == Layer::Kind::light || layer.kind == Layer::Kind::irradiance)
        return display::to_codes(layer.image, display);
    const Range depths = layer.kind == Layer::Kind::depth ? depth_range(layer.image) : Range{};
    image::RadianceImage scaled = layer.image;
    for (std::size_t i = 0; i < scaled.values.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c) {
            const float coverage = scaled.values[i + 3];
            scaled.values[i + c] =
                coverage > 0.0f ? shown(layer.kind, uncovered(scaled.values[i + c], coverage), depths) : 0.0f;
        }
    // Reflectance is encoded like light; other layers are numbers, which are not encoded.
    display::Settings plain;
    plain.tone = display::Tone::linear;
    plain.encode = layer.kind == Layer::Kind::color;
    return display::to_codes(scaled, plain);
}

void make_layer_folder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw Error(Failure::cannot_write,
                    text(folder.string(), ": cannot make the folder: ", error.message()));
    check_can_write(folder / "depth.exr");
}

std::vector<std::filesystem::path> layer_files(const std::vector<draw::Layer>& layers,
                                               const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    files.reserve(2 * layers.size());
    for (const draw::Layer& layer : layers)
        for (const char* extension : {".exr", ".png"})
            files.push_back(folder / (layer.name + extension));
    return files;
}

void write_layers(const std::vector<draw::Layer>& layers, const std::filesystem::path& folder,
                  const display::Settings& display)
{
    tbb::parallel_for(std::size_t{0}, layers.size(), [&](std::size_t i) {
        image::write_radiance(layers[i].image, folder / (layers[i].name + ".exr"));
        image::write_codes(layer_picture(layers[i], display), folder / (layers[i].name + ".png"));
    });
}

} // namespace lambent::cli
