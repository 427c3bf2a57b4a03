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

/// Reads the positions, which the primitive must have, and, if it has them, normals, tangents (only with normals), the
/// sets of texture coordinates that are needed, the first two always, and colours. Faulty attributes are left out with
/// a warning; for faulty positions Error(bad_input) is thrown.
void read_attributes(const Document& document, const PrimitivePart& part, const TextureNeeds& needs,
                     Losses& losses, Mesh& mesh);

/// Whether the attribute is read. Others are not checked.
bool is_read(const std::string& attribute, const TextureNeeds& needs);

} // namespace lambent::scene
