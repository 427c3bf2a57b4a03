// Uses of textures by materials: images, samplers and transforms.
#pragma once

#include "scene/gltf_document/gltf_document.h"
#include "scene/gltf_document/gltf_losses.h"
#include "scene/scene.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lambent::scene {

/// Reads uses of textures, and numbers the images that they refer to in the order of first use.
class TextureReader {
public:
    TextureReader(const Document& document, Losses& losses) : document_(document), losses_(losses) {}

    /// A texture of a material, both of which `where` ("material 3") and `slot` ("normalTexture") name in messages. A
    /// texture that cannot be read is left out with a warning; an unknown filter or wrap mode, or a sampler that does
    /// not exist, is replaced by the default (linear, repeating) with a warning.
    TextureUse read(const gltf::TextureInfo& info, const std::string& where, std::string_view slot);

    /// The file's image for each number of an image.
    const std::vector<int>& images() const { return images_; }

private:
    TextureUse find(const gltf::TextureInfo& info, const std::string& where, std::string_view slot);
    Sampler find_sampler(int index, const std::string& where);
    int scene_image(int image);

    const Document& document_;
    Losses& losses_;
    std::map<std::pair<int, std::string_view>, int> image_index_; ///< by bufferView and uri
    std::vector<int> images_;
};

} // namespace lambent::scene
