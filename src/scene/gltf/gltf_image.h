// Pictures inside and beside a glTF.
#pragma once

#include "scene/scene.h"
#include "scene/gltf_document/gltf_document.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace lambent::scene {

struct DecodedImages {
    std::vector<image::CodeImage> images; ///< those that could be read
    std::vector<int> index;               ///< of each that was listed: where it is in `images`; -1: left out
};

/// Decodes the listed images of the file, in parallel. One that cannot be read is left out with a warning; one that is
/// damaged is read as far as it goes, with a warning. Sizes are looked at first: all together may have 2^30 pixels, and
/// what comes beyond is left out.
DecodedImages read_images(const Document& document, std::span<const int> images, Warnings& warnings);

/// Lets the materials use images by their new numbers, and leave out those that are not there.
void renumber_images(std::span<const int> index, std::span<Material> materials);

} // namespace lambent::scene
