// A small file for those who damage it: hostile tests and the fuzzer's seeds.
#pragma once

#include "tests/scene/gltf_builder.h"

namespace lambent::scene::test {

/// Two nodes show one mesh, once skinned, with sparse, normalized and morphed vertices, a strip of indices, a
/// normal map, a camera and a light, and an animation moves them: most of what the loader reads.
GltfBuilder rich_file();

} // namespace lambent::scene::test
