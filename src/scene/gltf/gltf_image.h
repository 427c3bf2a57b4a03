// Images inside and beside a glTF.
#pragma once

#include "scene/scene.h"
#include "scene/gltf_document/gltf_document.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace lambent::scene {

struct DecodedImages {
    std::vector<image::CodeImage> images; ///< those that could be read
    std::vector<int> index;               ///< into `images`, for each listed image; -1: left out
};

/// Decodes the listed images of the file, in parallel. An image that cannot be read is left out with a warning; a
/// damaged one is decoded as far as possible, with a warning. Sizes are checked first: images beyond 2^30 pixels in
/// all are left out.
DecodedImages read_images(const Document& document, std::span<const int> images, Warnings& warnings);

/// Replaces the materials' indices of images by those in `index`, which is -1 (no texture) for images that were left
/// out.
void renumber_images(std::span<const int> index, std::span<Material> materials);

} // namespace lambent::scene
