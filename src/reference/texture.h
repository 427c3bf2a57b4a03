// Reads textures without mip maps: bilinear between texels, or the nearest texel if the sampler's magnification
// filter asks for it. Each pixel averages many rays, which minification filters only approximate.
#pragma once

#include "scene/scene.h"
#include "view/picture.h"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double4.hpp>

namespace lambent::reference {

/// Linear RGBA at texture coordinates. `transfer` decodes the colour codes; those of alpha are always linear.
glm::dvec4 read_texture(const image::CodeImage& image, const scene::Sampler& sampler,
                        view::TexelTransfer transfer, const glm::dvec2& uv);

} // namespace lambent::reference
