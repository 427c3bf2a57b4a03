// What the compiled shaders take their buffers for, read out of their SPIR-V, against gpu_layout in C++.
#include "draw/vulkan/passes.h"
#include "gpu_layout/layout.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace lambent::draw {
namespace {

using namespace gpu_layout;
using Code = std::span<const std::uint32_t>;

// The few instructions of SPIR-V that say what stands where. [SPIR-V 1.6, 3.49]
struct Reflection {
    std::map<std::uint32_t, std::uint32_t> binding_of, set_of, stride_of, pointee, element;
    std::map<std::uint32_t, std::vector<std::uint32_t>> members;
    std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> offsets;
    std::map<std::uint32_t, std::uint32_t> type_of_variable;

    explicit Reflection(Code code)
    {
        for (std::size_t at = 5; at < code.size(); at += code[at] >> 16)
            read(code.subspan(at, code[at] >> 16));
    }

private:
    void read(Code op)
    {
        constexpr std::uint32_t decorate = 71, member_decorate = 72, runtime_array = 29, structure = 30,
                                pointer = 32, variable = 59, array_stride = 6, binding = 33, set = 34,
                                offset = 35;
        const std::uint32_t code = op[0] & 0xffffu;
        if (code == decorate && op[2] == array_stride)
            stride_of[op[1]] = op[3];
        else if (code == decorate && op[2] == binding)
            binding_of[op[1]] = op[3];
        else if (code == decorate && op[2] == set)
            set_of[op[1]] = op[3];
        else if (code == member_decorate && op[3] == offset)
            offsets[op[1]][op[2]] = op[4];
        else if (code == runtime_array)
            element[op[1]] = op[2];
        else if (code == structure)
            members[op[1]].assign(op.begin() + 2, op.end());
        else if (code == pointer)
            pointee[op[1]] = op[3];
        else if (code == variable)
            type_of_variable[op[2]] = op[1];
    }
};

struct Shader {
    const char* name;
    std::vector<std::uint32_t> code;
};

const std::vector<Shader>& shaders()
{
    static const std::vector<Shader> all = {{
                                                "background",
#include "vulkan/background.comp.spv.inc"
                                            },
                                            {
                                                "edges",
#include "vulkan/edges.comp.spv.inc"
                                            },
                                            {
                                                "gather",
#include "vulkan/gather.comp.spv.inc"
                                            },
                                            {
                                                "ids.frag",
#include "vulkan/ids.frag.spv.inc"
                                            },
                                            {
                                                "ids.vert",
#include "vulkan/ids.vert.spv.inc"
                                            },
                                            {
                                                "light",
#include "vulkan/light.comp.spv.inc"
                                            },
                                            {
                                                "resolve",
#include "vulkan/resolve.comp.spv.inc"
                                            },
                                            {
                                                "seen",
#include "vulkan/seen.comp.spv.inc"
                                            },
                                            {
                                                "surface",
#include "vulkan/surface.comp.spv.inc"
                                            }};
    return all;
}

// Bytes from element to element of the buffers that are arrays.
const std::map<int, std::size_t> strides = {{binding_fragments, sizeof(float)},
                                            {binding_lights, sizeof(LightRecord)},
                                            {binding_samples, sizeof(SampleRecord)},
                                            {binding_lamps, sizeof(LampRecord)},
                                            {binding_albedo, 2 * sizeof(float)},
                                            {binding_instances, sizeof(InstanceRecord)},
                                            {binding_meshes, sizeof(MeshRecord)},
                                            {binding_materials, sizeof(MaterialRecord)},
                                            {binding_textures, sizeof(TextureRecord)},
                                            {binding_codes, sizeof(float)},
                                            {binding_places, 2 * sizeof(float)},
                                            {binding_seen, sizeof(uvec4)},
                                            {binding_records, sizeof(FragmentRecord)},
                                            {binding_spans, sizeof(uvec4)},
                                            {binding_behind, sizeof(vec4)},
                                            {binding_counters, sizeof(uint)},
                                            {binding_listed, sizeof(uint)},
                                            {binding_output, sizeof(vec4)}};

const std::vector<std::size_t> picture_offsets = {
    offsetof(PictureRecord, across),       offsetof(PictureRecord, rotation),
    offsetof(PictureRecord, chain),        offsetof(PictureRecord, maps),
    offsetof(PictureRecord, fragments),    offsetof(PictureRecord, samples),
    offsetof(PictureRecord, origin),       offsetof(PictureRecord, origin_dx),
    offsetof(PictureRecord, origin_dy),    offsetof(PictureRecord, direction),
    offsetof(PictureRecord, direction_dx), offsetof(PictureRecord, direction_dy),
    offsetof(PictureRecord, tile),         offsetof(PictureRecord, apron),
    offsetof(PictureRecord, surfaces),     offsetof(PictureRecord, edges),
    offsetof(PictureRecord, corners),      offsetof(PictureRecord, background),
    offsetof(PictureRecord, blur),         offsetof(PictureRecord, behind),
    offsetof(PictureRecord, panorama),     offsetof(PictureRecord, report),
    offsetof(PictureRecord, addresses),    offsetof(PictureRecord, layers)};

void expect_picture(const Reflection& r, std::uint32_t record, const char* shader)
{
    ASSERT_EQ(r.members.at(record).size(), picture_offsets.size()) << shader;
    for (std::uint32_t i = 0; i < picture_offsets.size(); ++i)
        EXPECT_EQ(r.offsets.at(record).at(i), picture_offsets[i]) << shader << ", member " << i;
}

TEST(ShaderLayout, EveryBufferIsWhatTheProgramPutsThere)
{
    std::map<int, int> seen;
    for (const Shader& shader : shaders()) {
        ASSERT_EQ(shader.code.at(0), 0x07230203u) << shader.name;
        const Reflection r(shader.code);
        for (const auto& [variable, binding] : r.binding_of) {
            const int number = static_cast<int>(binding);
            ++seen[number];
            EXPECT_LT(number, binding_count) << shader.name;
            EXPECT_EQ(r.set_of.at(variable), 0u) << shader.name;
            const std::uint32_t type = r.pointee.at(r.type_of_variable.at(variable));
            if (!r.members.contains(type)) {
                EXPECT_GE(number, binding_chain) << shader.name << ": not a buffer";
                continue;
            }
            const std::uint32_t content = r.members.at(type).at(0);
            if (number == binding_picture) {
                expect_picture(r, content, shader.name);
                continue;
            }
            ASSERT_TRUE(strides.contains(number)) << shader.name << ", binding " << number;
            EXPECT_EQ(r.stride_of.at(content), strides.at(number)) << shader.name << ", binding " << number;
        }
    }
    // Every binding is used by some shader.
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(binding_count));
}

} // namespace
} // namespace lambent::draw
