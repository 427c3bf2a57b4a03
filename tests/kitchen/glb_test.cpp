// The kitchen as a glTF file: read again, it is the same room.
#include "kitchen/glb.h"
#include "kitchen/model/kitchen.h"
#include "scene/gltf/gltf.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <optional>

namespace lambent {
namespace {

// The colour of a vertex: its own times the material's.
glm::vec3 color_at(const scene::Scene& scene, const scene::Mesh& mesh, std::size_t vertex)
{
    const glm::vec4& base = scene.materials[static_cast<std::size_t>(mesh.material)].base_color;
    return mesh.colors.empty() ? glm::vec3(base) : glm::vec3(base) * glm::vec3(mesh.colors[vertex]);
}

void expect_same_mesh(const scene::Scene& a, const scene::Scene& b, std::size_t i)
{
    const scene::Mesh &mine = a.meshes[i], &read = b.meshes[i];
    ASSERT_EQ(mine.positions, read.positions);
    EXPECT_EQ(mine.triangles, read.triangles);
    EXPECT_EQ(mine.texcoords[0], read.texcoords[0]);
    for (std::size_t v = 0; v < mine.positions.size(); v += 7) {
        ASSERT_NEAR(glm::distance(mine.normals[v], read.normals[v]), 0.0f, 1e-5f);
        ASSERT_NEAR(glm::distance(color_at(a, mine, v), color_at(b, read, v)), 0.0f, 1e-5f);
    }
}

TEST(KitchenModel, ComesBackFromItsFile)
{
    const scene::Scene room = kitchen::make_kitchen();
    const std::vector<std::uint8_t> file = encode_glb(room);
    Warnings warnings;
    const scene::Scene read = scene::load_gltf_bytes({"kitchen.glb", file, std::nullopt, {}}, warnings);
    EXPECT_TRUE(warnings.empty()) << warnings.front();
    ASSERT_EQ(read.meshes.size(), room.meshes.size());
    for (std::size_t i = 0; i < room.meshes.size(); ++i)
        expect_same_mesh(room, read, i);
    ASSERT_EQ(read.images.size(), room.images.size());
    for (std::size_t i = 0; i < room.images.size(); ++i)
        EXPECT_EQ(read.images[i].bytes, room.images[i].bytes);
    for (std::size_t i = 0; i < room.materials.size(); ++i) {
        const scene::Material &mine = room.materials[i], &other = read.materials[i];
        EXPECT_EQ(mine.name, other.name);
        EXPECT_NEAR(glm::distance(mine.emissive, other.emissive), 0.0f, 1e-6f);
        EXPECT_EQ(mine.perceptual_roughness, other.perceptual_roughness);
        EXPECT_EQ(mine.metallic, other.metallic);
        EXPECT_EQ(mine.double_sided, other.double_sided);
        EXPECT_EQ(mine.base_color_texture.transform, other.base_color_texture.transform);
    }
}

} // namespace
} // namespace lambent
