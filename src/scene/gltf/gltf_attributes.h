// The attributes of a primitive's vertices.
#pragma once

#include "scene/gltf/gltf_accessor.h"
#include "scene/gltf/gltf_deform.h"
#include "scene/gltf_document/gltf_losses.h"
#include "scene/gltf/gltf_primitive.h"

#include <optional>
#include <string>

namespace lambent::scene {

/// The attribute's accessor, if the primitive has it.
std::optional<AccessorUse> find_attribute(const PrimitivePart& part, const std::string& name);

/// Fills the mesh's positions, which the primitive must have, and what it has beside them: normals, tangents (with normals
/// only), the sets of texture coordinates that are needed, the first two always, and colours. What is faulty, but for the
/// positions, is left out with a warning. Throws Error(bad_input) for the positions.
void read_attributes(const Document& document, const PrimitivePart& part, const TextureNeeds& needs,
                     Losses& losses, Mesh& mesh);

/// Whether the attribute is read at all: the others may be of any kind.
bool is_read(const std::string& attribute, const TextureNeeds& needs);

} // namespace lambent::scene
