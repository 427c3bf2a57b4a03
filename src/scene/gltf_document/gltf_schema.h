// The part of the glTF 2.0 schema that the loader relies on, as tables. [glTF 2.0, 5]
#pragma once

#include "scene/gltf_document/gltf_table.h"

namespace lambent::scene {

/// The shape of a whole document; fills a gltf::Model.
const Shape& document_shape();

/// The shape of a material; fills a gltf::Material (gltf_material_schema.cpp).
const Shape& material_shape();

} // namespace lambent::scene
