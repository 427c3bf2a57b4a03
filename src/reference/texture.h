// Textures as they are in the file: bilinear between texels, or the nearest one where the sampler magnifies so; without mip
// maps. Pixels average many rays instead, which is what all minifying filters stand for.
#pragma once

#include "scene/scene.h"
#include "view/picture.h"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double4.hpp>

namespace lambent::reference {

/// Linear RGBA at texture coordinates, as the sampler and the transfer of colour codes say; alpha is linear always.
glm::dvec4 read_texture(const image::CodeImage& image, const scene::Sampler& sampler,
                        view::TexelTransfer transfer, const glm::dvec2& uv);

} // namespace lambent::reference
