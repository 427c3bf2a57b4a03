#include "scene/gltf_image.h"

#include "image/image_io.h"
#include "image/jpeg.h"
#include "image/png.h"
#include "scene/gltf_uri.h"
#include "scene/parallel.h"

#include <cstdint>

namespace lambent::scene {
namespace {

constexpr std::uint64_t most_pixels = std::uint64_t{1} << 30;

// An image still in its file format.
struct Encoded {
    std::string name; ///< for messages: file, number and name or uri
    std::vector<std::uint8_t> storage;
    std::span<const std::uint8_t> bytes; ///< in `storage` or in a buffer
};

Encoded find_bytes(const Document& document, int index)
{
    const ImageSource& source = document.images[static_cast<std::size_t>(index)];
    Encoded encoded;
    encoded.name = text(document.file, ": image ", index);
    const bool data_uri = is_data_uri(source.uri);
    const std::string& hint = source.uri.empty() || data_uri ? source.name : source.uri;
    if (source.buffer_view >= 0) {
        encoded.bytes = view_bytes(document, source.buffer_view, text("image ", index));
    } else {
        encoded.storage = data_uri ? decode_data_uri(source.uri, encoded.name)
                                   : read_beside(document.folder, source.uri, encoded.name);
        encoded.bytes = encoded.storage;
    }
    if (!hint.empty())
        encoded.name += text(" (", printable(hint), ")");
    return encoded;
}

std::uint64_t pixels_of(const Encoded& encoded)
{
    image::ImageInfo info;
    if (image::is_png(encoded.bytes))
        info = image::inspect_png(encoded.bytes, encoded.name);
    else if (image::is_jpeg(encoded.bytes))
        info = image::inspect_jpeg(encoded.bytes, encoded.name);
    else
        refuse(encoded.name, ": neither PNG nor JPEG");
    return static_cast<std::uint64_t>(info.width) * static_cast<std::uint64_t>(info.height);
}

} // namespace

std::vector<image::CodeImage> read_images(const Document& document, std::span<const int> images)
{
    std::vector<Encoded> encoded(images.size());
    parallel_for_each_index(images.size(),
                            [&](std::size_t i) { encoded[i] = find_bytes(document, images[i]); });
    std::uint64_t pixels = 0;
    for (const Encoded& one : encoded)
        pixels += pixels_of(one);
    if (pixels > most_pixels)
        document.fail("its images have ", pixels, " pixels together, at most ", most_pixels, " are read");
    std::vector<image::CodeImage> decoded(images.size());
    parallel_for_each_index(images.size(), [&](std::size_t i) {
        decoded[i] = image::decode_codes(encoded[i].bytes, encoded[i].name);
    });
    return decoded;
}

} // namespace lambent::scene
