// Pictures inside and beside a glTF.
#pragma once

#include "scene/gltf_document.h"

#include <span>
#include <vector>

namespace lambent::scene {

/// Decodes the listed images of the file, in parallel. Their sizes are added up first: all together may have
/// 2^30 pixels. Throws Error(bad_input) naming the image; of several broken ones, the first.
std::vector<image::CodeImage> read_images(const Document& document, std::span<const int> images);

} // namespace lambent::scene
