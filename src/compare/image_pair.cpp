#include "compare/image_pair.h"

#include "base/text.h"
#include "image/files/image_io.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

namespace lambent::compare {
namespace {

namespace fs = std::filesystem;

struct Header {
    int width, height;
    Kind kind;
};

Header header_of(const fs::path& path)
{
    Warnings repeated; // by the reader of the pixels
    const image::ImageInfo info = image::inspect(path, &repeated);
    const bool codes = info.format == "PNG" || info.format == "JPEG";
    return {info.width, info.height, codes ? Kind::srgb : Kind::linear};
}

std::string describe(const fs::path& path, const Header& header)
{
    return text(path.string(), " is ", header.width, "x", header.height, " ", name_of(header.kind));
}

float code_at(const image::CodeImage& codes, std::size_t i)
{
    if (codes.bits == 8)
        return static_cast<float>(codes.bytes[i]) / 255.0f;
    std::uint16_t code = 0;
    std::memcpy(&code, codes.bytes.data() + 2 * i, sizeof code);
    return static_cast<float>(code) / 65535.0f;
}

image::RadianceImage read_as_values(const fs::path& path, Warnings& warnings)
{
    const image::CodeImage codes = image::read_codes(path, &warnings);
    image::RadianceImage values{codes.width, codes.height, 3, {}};
    const auto width = static_cast<std::size_t>(codes.width),
               channels = static_cast<std::size_t>(codes.channels);
    values.values.resize(width * static_cast<std::size_t>(codes.height) * 3);
    tbb::parallel_for(std::size_t{0}, static_cast<std::size_t>(codes.height), [&](std::size_t y) {
        for (std::size_t i = y * width; i < (y + 1) * width; ++i)
            for (std::size_t c = 0; c < 3; ++c)
                values.values[3 * i + c] = code_at(codes, channels * i + c);
    });
    return values;
}

// Calls change(value) for every value.
template <class Change>
void for_each_value(image::RadianceImage& picture, Change&& change)
{
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, picture.values.size(), 1 << 16),
                      [&](const auto& range) {
                          for (std::size_t i = range.begin(); i < range.end(); ++i)
                              change(picture.values[i]);
                      });
}

void mend(image::RadianceImage& picture, const fs::path& path, Warnings& warnings)
{
    std::size_t broken = 0;
    for (float& value : picture.values)
        if (!std::isfinite(value)) {
            value = 0.0f;
            ++broken;
        }
    if (broken > 0)
        warnings.push_back(text(path.string(), ": ", broken, broken == 1 ? " value is" : " values are",
                                " not finite, taken as 0"));
}

image::RadianceImage read(const fs::path& path, const Header& header, Warnings& warnings)
{
    if (header.kind == Kind::srgb)
        return read_as_values(path, warnings);
    image::RadianceImage picture = image::read_radiance(path, warnings);
    mend(picture, path, warnings);
    return picture;
}

} // namespace

const char* name_of(Kind kind)
{
    return kind == Kind::srgb ? "srgb" : "linear";
}

ImagePair read_image_pair(const fs::path& picture, const fs::path& reference, Warnings& warnings)
{
    const Header a = header_of(picture), b = header_of(reference);
    if (a.width != b.width || a.height != b.height || a.kind != b.kind)
        throw Error(Failure::bad_input, text(describe(picture, a), ", ", describe(reference, b),
                                             ": only pictures of one size and kind can be compared"));
    ImagePair pictures{a.kind, read(picture, a, warnings), read(reference, b, warnings), {}};
    // A file may have changed since its header was read.
    if (pictures.picture.values.size() != pictures.reference.values.size() ||
        pictures.picture.width != pictures.reference.width)
        throw Error(Failure::bad_input, text(picture.string(), ": changed while it was read"));
    return pictures;
}

void keep_covered(const fs::path& picture, const fs::path& reference, ImagePair& pictures)
{
    pictures.covered.assign(pictures.picture.values.size() / 3, 0);
    for (const fs::path* path : {&picture, &reference}) {
        const std::vector<float> coverage = image::read_coverage(*path);
        if (coverage.size() != pictures.covered.size())
            throw Error(Failure::bad_input, text(path->string(), ": --covered: has no alpha channel; "
                                                                 "lambent writes it to .exr files"));
        for (std::size_t i = 0; i < coverage.size(); ++i)
            pictures.covered[i] = pictures.covered[i] != 0 || coverage[i] > 0.0f ? 1 : 0;
    }
    if (std::find(pictures.covered.begin(), pictures.covered.end(), 1) == pictures.covered.end())
        throw Error(Failure::bad_input, text(picture.string(), ", ", reference.string(),
                                             ": --covered: no surface covers any pixel"));
}

void expose(image::RadianceImage& picture, float factor)
{
    constexpr float largest = std::numeric_limits<float>::max();
    for_each_value(picture, [=](float& value) { value = std::clamp(value * factor, -largest, largest); });
}

void clamp(image::RadianceImage& picture, float limit)
{
    for_each_value(picture, [limit](float& value) { value = std::clamp(value, 0.0f, limit); });
}

} // namespace lambent::compare
