// Samplers of textures.
#pragma once

#include "scene/gltf_document/gltf_document.h"
#include "scene/gltf_document/gltf_losses.h"
#include "scene/scene.h"

namespace lambent::scene {

/// A sampler of the file. An unknown filter or wrap mode is replaced by the default (linear, repeating), with a
/// warning.
Sampler read_sampler(const Document& document, int index, Losses& losses);

} // namespace lambent::scene
