#include "scene/gltf/gltf_image.h"

#include "image/files/image_io.h"
#include "image/codes/jpeg.h"
#include "image/codes/png.h"
#include "scene/gltf_document/gltf_losses.h"
#include "scene/gltf_document/gltf_uri.h"
#include "scene/parallel.h"

#include <cstdint>

namespace lambent::scene {
namespace {

constexpr std::uint64_t most_pixels = std::uint64_t{1} << 30;

// An image in its file format.
struct Encoded {
    std::string name; ///< for messages: file, number and name or uri
    std::vector<std::uint8_t> storage;
    std::span<const std::uint8_t> bytes; ///< in `storage` or in a buffer
};

Encoded find_bytes(const Document& document, int index)
{
    const gltf::Image& source = document.model.images[static_cast<std::size_t>(index)];
    Encoded encoded;
    encoded.name = text(document.file, ": image ", index);
    if (source.is_broken)
        throw told_already();
    if (source.uri.empty() == (source.buffer_view < 0))
        refuse(encoded.name, ": needs either a uri or a bufferView");
    const bool data_uri = is_data_uri(source.uri);
    const std::string& hint = source.uri.empty() || data_uri ? source.name : source.uri;
    if (source.buffer_view >= 0) {
        encoded.bytes = view_bytes(document, source.buffer_view, text("image ", index));
    } else {
        encoded.storage = data_uri ? decode_data_uri(source.uri, encoded.name)
                                   : read_beside(document.base, source.uri, encoded.name);
        encoded.bytes = encoded.storage;
    }
    if (!hint.empty())
        encoded.name += text(" (", printable(hint), ")");
    return encoded;
}

std::uint64_t pixels_of(const Encoded& encoded)
{
    Warnings told_when_decoded;
    image::ImageInfo info;
    if (image::is_png(encoded.bytes))
        info = image::inspect_png(encoded.bytes, encoded.name);
    else if (image::is_jpeg(encoded.bytes))
        info = image::inspect_jpeg(encoded.bytes, encoded.name, &told_when_decoded);
    else
        refuse(encoded.name, ": neither PNG nor JPEG");
    return static_cast<std::uint64_t>(info.width) * static_cast<std::uint64_t>(info.height);
}

// One of the listed images while it is read.
struct Work {
    Encoded encoded;
    std::uint64_t pixels = 0;
    image::CodeImage image;
    Warnings warnings; ///< of its decoder
    std::string fault; ///< why it is left out; empty if that was reported before
    bool is_lost = false;

    template <class Step>
    void go_on(Step&& step)
    {
        if (is_lost)
            return;
        try {
            step();
        } catch (const Error& error) {
            fault = error.what();
            is_lost = true;
            encoded = {};
        }
    }
};

// Leaves out images that exceed the limit of all pixels, in the order of the list.
void check_pixels(std::span<Work> images)
{
    std::uint64_t pixels = 0;
    for (Work& work : images)
        work.go_on([&] {
            if (pixels + work.pixels > most_pixels)
                refuse(work.encoded.name, ": ", work.pixels,
                       " pixels, together with the images before it more than ", most_pixels);
            pixels += work.pixels;
        });
}

} // namespace

DecodedImages read_images(const Document& document, std::span<const int> images, Warnings& warnings)
{
    std::vector<Work> works(images.size());
    parallel_for_each_index(images.size(), [&](std::size_t i) {
        works[i].go_on([&] {
            works[i].encoded = find_bytes(document, images[i]);
            works[i].pixels = pixels_of(works[i].encoded);
        });
    });
    check_pixels(works);
    parallel_for_each_index(images.size(), [&](std::size_t i) {
        works[i].go_on([&] {
            works[i].image =
                image::decode_codes(works[i].encoded.bytes, works[i].encoded.name, &works[i].warnings);
        });
    });
    Losses losses(document.file, warnings);
    DecodedImages decoded;
    for (Work& work : works) {
        decoded.index.push_back(work.is_lost ? -1 : static_cast<int>(decoded.images.size()));
        for (const std::string& warning : work.warnings)
            losses.add(warning);
        losses.add(work.fault, "the texture is left out");
        if (!work.is_lost)
            decoded.images.push_back(std::move(work.image));
    }
    return decoded;
}

void renumber_images(std::span<const int> index, std::span<Material> materials)
{
    for (Material& material : materials)
        for_each_texture(material, [&](int, TextureUse& use, TextureCodes) {
            if (use.image >= 0)
                use.image = index[static_cast<std::size_t>(use.image)];
        });
}

} // namespace lambent::scene
