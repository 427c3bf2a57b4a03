#include "draw/vulkan/scene_on_device.h"

#include "base/error.h"
#include "draw/textures/typical_alpha.h"
#include "draw/vulkan/filled_buffer.h"
#include "gpu_layout/layout.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace lambent::draw {
namespace {

using namespace gpu_layout;
using Bytes = std::span<const std::byte>;

constexpr VkBufferUsageFlags by_address = VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;

// Arrays stored one after the other as words of 32 bits; add() returns the offset of an array.
class Words {
public:
    template <class Record>
    uint add(const std::vector<Record>& records)
    {
        if (records.empty())
            return no_words;
        const std::uint64_t place = size_;
        parts_.push_back(std::as_bytes(std::span(records)));
        size_ += parts_.back().size() / sizeof(uint);
        if (size_ > std::numeric_limits<std::int32_t>::max())
            throw Error(Failure::no_device, "the scene's geometry exceeds the 8 GiB that a device can draw");
        return static_cast<uint>(place);
    }
    std::span<const Bytes> parts() const { return parts_; }

private:
    std::uint64_t size_ = 0;
    std::vector<Bytes> parts_;
};

bool mirrors(const scene::Instance& instance)
{
    return glm::determinant(glm::mat3(instance.transform)) < 0.0f;
}

// Row i of a matrix, which glm stores by columns.
vec4 row(const glm::mat4& m, int i)
{
    return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

UseRecord use_record(const scene::TextureUse& use, int texture)
{
    const glm::mat3& m = use.transform;
    return {{m[0][0], m[1][0], m[2][0], 0.0f}, {m[0][1], m[1][1], m[2][1], 0.0f}, {texture, 0, 0, 0}};
}

vec4 given(const std::optional<glm::vec3>& color)
{
    return color ? vec4(*color, 1.0f) : vec4(0.0f);
}

int alpha_of(scene::AlphaMode mode)
{
    if (mode == scene::AlphaMode::mask)
        return alpha_mask;
    return mode == scene::AlphaMode::blend ? alpha_blend : alpha_opaque;
}

int wrap_of(scene::Wrap wrap)
{
    if (wrap == scene::Wrap::repeat)
        return wrap_repeat;
    return wrap == scene::Wrap::clamp_to_edge ? wrap_clamp : wrap_mirrored;
}

int filters_of(const scene::Sampler& sampler)
{
    return (sampler.magnify_nearest ? filter_magnify_nearest : 0) |
           (sampler.minify_nearest ? filter_minify_nearest : 0) |
           (sampler.nearest_mipmap ? filter_nearest_mipmap : 0);
}

constexpr std::array code_tables = {TexelTransfer::none, TexelTransfer::srgb, TexelTransfer::power_2_2};

TextureRecord texture_record(const PackedTexture& texture, VkDeviceAddress address)
{
    static_assert(most_texture_levels == PackedTexture::most_levels);
    TextureRecord record{};
    const auto table =
        std::find(code_tables.begin(), code_tables.end(), texture.transfer) - code_tables.begin();
    record.place = {static_cast<uint>(address), static_cast<uint>(address >> 32),
                    texture.half_floats ? 1u : 0u, static_cast<uint>(table)};
    record.reading = {wrap_of(texture.sampler.wrap_u), wrap_of(texture.sampler.wrap_v),
                      filters_of(texture.sampler), texture.levels};
    for (int level = 0; level < texture.levels; ++level)
        record.levels[level] = {texture.width[level], texture.height[level], texture.start[level], 0};
    return record;
}

} // namespace

SceneOnDevice::SceneOnDevice(const vulkan::Device& device, const scene::Scene& scene,
                             const scene::Scene& posed, TexelTransfer transfer)
{
    const SceneTextures textures(scene, transfer);
    place_materials(device, scene, textures);
    place_textures(device, textures);
    pose(device, posed);
}

void SceneOnDevice::pose(const vulkan::Device& device, const scene::Scene& posed)
{
    for (std::optional<vulkan::Buffer>* buffer :
         {&geometry_, &positions_, &indices_, &instances_, &meshes_, &draws_})
        buffer->reset(); // frees their memory before the next are made
    batches_.clear();
    transparent_ = false;
    place_instances(device, posed, place_geometry(device, posed));
    plan_draws(device, posed);
}

// Positions and indices are also stored in buffers of their own, for the rasteriser.
SceneOnDevice::SetPlaces SceneOnDevice::place_geometry(const vulkan::Device& device,
                                                       const scene::Scene& scene)
{
    Words words, positions, indices;
    SetPlaces sets;
    std::vector<MeshRecord> records;
    for (const scene::Mesh& mesh : scene.meshes) {
        const uvec4 vectors(words.add(mesh.positions), words.add(mesh.normals), words.add(mesh.tangents),
                            words.add(mesh.colors));
        records.push_back({vectors, {words.add(mesh.triangles), 0, 0, 0}});
        auto& places = sets.emplace_back();
        for (const auto& [number, set] : mesh.texcoords)
            places.emplace(number, words.add(set));
        positions.add(mesh.positions);
        indices.add(mesh.triangles);
    }
    geometry_.emplace(filled_buffer(device, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | by_address, words.parts()));
    positions_.emplace(filled_buffer(device, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, positions.parts()));
    indices_.emplace(filled_buffer(device, VK_BUFFER_USAGE_INDEX_BUFFER_BIT, indices.parts()));
    meshes_.emplace(filled_buffer(device, records));
    return sets;
}

void SceneOnDevice::place_instances(const vulkan::Device& device, const scene::Scene& scene,
                                    const SetPlaces& sets)
{
    std::vector<InstanceRecord> records;
    for (const scene::Instance& instance : scene.instances) {
        const glm::mat4 normals(glm::transpose(glm::inverse(glm::mat3(instance.transform))));
        const scene::Material& material = scene.materials[scene::material_of(scene, instance)];
        const auto& places = sets[static_cast<std::size_t>(instance.mesh)];
        const auto set = [&](const scene::TextureUse& use) {
            const auto found = places.find(use.texcoord);
            return found == places.end() ? no_words : found->second;
        };
        InstanceRecord record{};
        record.row_x = row(instance.transform, 0);
        record.row_y = row(instance.transform, 1);
        record.row_z = row(instance.transform, 2);
        record.normal_x = row(normals, 0);
        record.normal_y = row(normals, 1);
        record.normal_z = row(normals, 2);
        record.normal_z.w = mirrors(instance) ? -1.0f : 1.0f;
        record.ids = {static_cast<uint>(instance.mesh), static_cast<uint>(&material - scene.materials.data()),
                      0, 0};
        for_each_texture(material, [&](int number, const scene::TextureUse& use, scene::TextureCodes) {
            record.sets[number] = set(use);
        });
        records.push_back(record);
    }
    instances_.emplace(filled_buffer(device, records));
}

void SceneOnDevice::place_materials(const vulkan::Device& device, const scene::Scene& scene,
                                    const SceneTextures& textures)
{
    std::vector<MaterialRecord> records;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const scene::Material& m = scene.materials[i];
        const MaterialTextures own = textures.of(i);
        MaterialRecord record{};
        std::ranges::copy(factors_of(m), record.factors);
        std::ranges::copy(normal_scales_of(m), record.normal_scales);
        record.phong_diffuse = given(m.phong.diffuse);
        record.phong_specular = given(m.phong.specular);
        record.phong_exponent = {m.phong.exponent.value_or(0.0f), m.phong.exponent ? 1.0f : 0.0f,
                                 m.alpha_cutoff, 0.0f};
        const TypicalAlpha typical(m, own);
        record.smoothness = {typical.ggx, typical.phong, 0.0f, 0.0f};
        record.kind = {alpha_of(m.alpha_mode), m.unlit ? 1 : 0, 0, 0};
        has_unlit_ = has_unlit_ || m.unlit;
        has_layers_ = has_layers_ || scene::has_layers(m);
        for_each_texture(m, [&](int number, const scene::TextureUse& use, scene::TextureCodes) {
            const int texture = textures.index(own[static_cast<std::size_t>(number)]);
            record.uses[number] = use_record(use, texture);
            if (texture >= 0)
                record.used[record.kind.z++] = number;
        });
        records.push_back(record);
    }
    materials_.emplace(filled_buffer(device, records));
}

void SceneOnDevice::place_textures(const vulkan::Device& device, const SceneTextures& textures)
{
    std::vector<TextureRecord> records;
    for (std::size_t i = 0; i < textures.size(); ++i) {
        const Bytes texels = std::as_bytes(std::span(textures[i].bytes));
        texels_.push_back(
            filled_buffer(device, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | by_address, {&texels, 1}));
        records.push_back(texture_record(textures[i], texels_.back().address()));
    }
    textures_.emplace(filled_buffer(device, records));
    std::vector<float> codes;
    for (const TexelTransfer transfer : code_tables)
        codes.insert(codes.end(), code_light(transfer), code_light(transfer) + 256);
    codes_.emplace(filled_buffer(device, codes));
}

// One draw per instance, in one batch per culling mode.
void SceneOnDevice::plan_draws(const vulkan::Device& device, const scene::Scene& scene)
{
    std::vector<VkDrawIndexedIndirectCommand> of_mesh;
    VkDrawIndexedIndirectCommand next{0, 1, 0, 0, 0};
    for (const scene::Mesh& mesh : scene.meshes) {
        next.indexCount = static_cast<uint>(3 * mesh.triangles.size());
        of_mesh.push_back(next);
        next.firstIndex += next.indexCount;
        next.vertexOffset += static_cast<std::int32_t>(mesh.positions.size());
    }
    std::array<std::vector<VkDrawIndexedIndirectCommand>, 3>
        draws; // both sides; front faces; front faces of mirrored instances
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        const scene::Material& material = scene.materials[scene::material_of(scene, instance)];
        VkDrawIndexedIndirectCommand draw = of_mesh[static_cast<std::size_t>(instance.mesh)];
        draw.firstInstance = static_cast<uint>(i);
        const std::size_t kind = mirrors(instance) ? 2 : 1;
        if (draw.indexCount > 0)
            draws[material.double_sided ? 0 : kind].push_back(draw);
        transparent_ = transparent_ || material.alpha_mode != scene::AlphaMode::opaque;
    }
    std::vector<VkDrawIndexedIndirectCommand> all;
    constexpr std::array sides = {VK_FRONT_FACE_COUNTER_CLOCKWISE, VK_FRONT_FACE_COUNTER_CLOCKWISE,
                                  VK_FRONT_FACE_CLOCKWISE};
    for (std::size_t kind = 0; kind < draws.size(); ++kind) {
        if (!draws[kind].empty())
            batches_.push_back(
                {nullptr, static_cast<uint>(all.size()), static_cast<uint>(draws[kind].size()),
                 static_cast<VkCullModeFlags>(kind == 0 ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT),
                 sides[kind]});
        all.insert(all.end(), draws[kind].begin(), draws[kind].end());
    }
    const Bytes bytes = std::as_bytes(std::span(all));
    draws_.emplace(filled_buffer(device, VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT, {&bytes, 1}));
    for (vulkan::DrawBatch& batch : batches_)
        batch.draws = &*draws_;
}

} // namespace lambent::draw
