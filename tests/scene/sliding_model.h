// A model that moves.
#pragma once

#include "tests/scene/gltf_builder.h"

#include <cstdint>
#include <vector>

namespace lambent::scene::test {

/// A triangle that "slides" a metre to the right in 2 s and "sinks" one in 4 s, as a .glb.
inline std::vector<std::uint8_t> sliding_model()
{
    using nlohmann::json;
    GltfBuilder builder = triangle();
    const auto animation = [&](const char* name, float seconds, const std::vector<float>& places) {
        const int times = builder.add("SCALAR", f32, std::vector<float>{0, seconds});
        return json{{"name", name},
                    {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                    {"samplers", {{{"input", times}, {"output", builder.add_vec3(places)}}}}};
    };
    builder.add_to("animations", animation("slide", 2, {0, 0, 0, 1, 0, 0}));
    builder.add_to("animations", animation("sink", 4, {0, 0, 0, 0, -1, 0}));
    return builder.glb();
}

} // namespace lambent::scene::test
