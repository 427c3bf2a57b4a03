#include "kitchen/model/stuff.h"

#include "kitchen/model/textures.h"

#include <glm/vec2.hpp>

namespace lambent::kitchen {
namespace {

struct Look {
    const char* name;
    glm::vec3 base_color;
    float metallic, perceptual_roughness;
};

scene::Material material(const Look& look)
{
    scene::Material m;
    m.name = look.name;
    m.base_color = glm::vec4(look.base_color, 1.0f);
    m.metallic = look.metallic;
    m.perceptual_roughness = look.perceptual_roughness;
    return m;
}

scene::Material light(const char* name, const glm::vec3& radiance)
{
    scene::Material m = material({name, glm::vec3(0.8f), 0.0f, 1.0f});
    m.emissive = radiance;
    return m;
}

// A texture whose image covers `size` metres.
scene::TextureUse texture(int image, const glm::vec2& size)
{
    scene::TextureUse use;
    use.image = image;
    use.transform[0][0] = 1.0f / size.x;
    use.transform[1][1] = 1.0f / size.y;
    return use;
}

} // namespace

Stuffs make_stuffs()
{
    const glm::vec3 white(0.8f);
    Stuffs s;
    s.images = {wood_texture(), marble_texture(), rug_texture()};
    s.materials = {
        material({"plaster", white, 0.0f, 0.9f}),
        material({"wood", glm::vec3(1.0f), 0.0f, 0.45f}),
        material({"lacquer", white, 0.0f, 0.35f}),
        material({"marble", glm::vec3(1.0f), 0.0f, 0.2f}),
        material({"stone", {0.46f, 0.45f, 0.43f}, 0.0f, 0.3f}),
        material({"steel", {0.60f, 0.59f, 0.57f}, 1.0f, 0.36f}),
        material({"chrome", {0.72f, 0.72f, 0.73f}, 1.0f, 0.22f}),
        material({"brass", {0.78f, 0.58f, 0.28f}, 1.0f, 0.32f}),
        material({"black glass", glm::vec3(0.012f), 0.0f, 0.15f}),
        material({"black", glm::vec3(0.03f), 0.0f, 0.5f}),
        material({"tile", white, 0.0f, 0.22f}),
        material({"ceramic", white, 0.0f, 0.25f}),
        material({"glass", white, 0.0f, 0.18f}),
        material({"fruit", white, 0.0f, 0.4f}),
        material({"leaf", white, 0.0f, 0.5f}),
        material({"cloth", white, 0.0f, 0.95f}),
        material({"rug", glm::vec3(1.0f), 0.0f, 1.0f}),
        light("bulb", {1.0f, 0.72f, 0.42f}),
        light("strip", {0.5f, 0.40f, 0.28f}),
        light("spot", {0.6f, 0.52f, 0.42f}),
    };
    const auto of = [&](Stuff stuff) -> scene::Material& {
        return s.materials[static_cast<std::size_t>(stuff)];
    };
    of(Stuff::wood).base_color_texture = texture(0, {0.7f, 1.9f});
    of(Stuff::marble).base_color_texture = texture(1, {1.9f, 1.9f});
    of(Stuff::rug).base_color_texture = texture(2, {1.0f, 1.0f});
    of(Stuff::leaf).double_sided = true;
    return s;
}

} // namespace lambent::kitchen
