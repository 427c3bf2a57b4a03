// What textures, factors, colours of vertices and alpha make of a surface.
#include "tests/draw/backend_checks.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lambent::draw::testing {
namespace {

using glm::vec2, glm::vec3, glm::vec4;

// Three texels by two, of one colour each.
image::CodeImage texels(const std::array<glm::ivec4, 6>& codes)
{
    image::CodeImage image{3, 2, 4, 8, {}};
    for (const glm::ivec4& code : codes)
        for (int c = 0; c < 4; ++c)
            image.bytes.push_back(static_cast<std::uint8_t>(code[c]));
    return image;
}

// An image whose texel number `at` has this code, the others its opposite.
image::CodeImage one_of(std::size_t at, const glm::ivec4& code)
{
    std::array<glm::ivec4, 6> codes;
    codes.fill(255 - code);
    codes[at] = code;
    return texels(codes);
}

Settings layered(int width, int height)
{
    Settings settings = small_settings(width, height, front_camera(static_cast<float>(height)));
    settings.texel_transfer = TexelTransfer::none;
    settings.layers = true;
    return settings;
}

void expect_layer(const Frame& frame, const char* name, const vec3& wanted)
{
    const vec3 found = layer_pixel(frame, name, 2, 2);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c], wanted[c], 2e-5f + 2e-5f * std::fabs(wanted[c])) << name << " " << c;
}

// The middle of texel (x, y), reached from the coordinates that a set has all over the mesh.
scene::TextureUse reading(int image, int set, const vec2& coordinates, int x, int y)
{
    scene::TextureUse use;
    use.image = image;
    use.texcoord = set;
    use.sampler.magnify_nearest = true;
    // A quarter turn, stretched: u comes from v, v from u; the place is then moved.
    use.transform = glm::mat3(vec3(0.0f, 2.0f, 0.0f), vec3(-0.5f, 0.0f, 0.0f), vec3(0.0f, 0.0f, 1.0f));
    const vec3 turned = use.transform * vec3(coordinates, 1.0f);
    use.transform[2] = vec3((static_cast<float>(x) + 0.5f) / 3.0f - turned.x,
                            (static_cast<float>(y) + 0.5f) / 2.0f - turned.y, 1.0f);
    return use;
}

constexpr vec2 set_coordinates[2] = {{0.3f, 0.8f}, {0.65f, 0.15f}};

scene::Mesh square_with_sets(float half)
{
    scene::Mesh mesh = facing_square(half, 0.0f);
    for (const int set : {0, 1})
        mesh.texcoords[set].assign(4, set_coordinates[set]);
    return mesh;
}

// All slots at once: the other slots must not reach into one's layer.
scene::Scene all_slots()
{
    scene::Scene scene;
    scene::Material m;
    m.base_color = {0.9f, 0.8f, 0.7f, 1.0f};
    m.metallic = 0.75f;
    m.perceptual_roughness = 0.5f;
    m.emissive = {3.0f, 2.0f, 1.0f};
    m.occlusion_strength = 0.5f;
    m.normal_scale = 2.0f;
    const auto use = [](int slot, int set) {
        return reading(slot, set, set_coordinates[set], slot % 3, slot % 2);
    };
    m.base_color_texture = use(0, 0);
    m.metallic_roughness_texture = use(1, 1);
    m.normal_texture = use(2, 0);
    m.occlusion_texture = use(3, 1);
    m.emissive_texture = use(4, 0);
    const glm::ivec4 codes[] = {
        {51, 102, 204, 255}, {7, 102, 204, 9}, {153, 204, 255, 3}, {102, 5, 250, 1}, {204, 153, 51, 77}};
    for (int slot = 0; slot < 5; ++slot) {
        const std::size_t at = static_cast<std::size_t>(slot % 3 + 3 * (slot % 2));
        scene.images.push_back(one_of(at, codes[slot]));
    }
    scene::Mesh mesh = square_with_sets(4.0f);
    mesh.colors.assign(4, {0.5f, 1.0f, 0.25f, 1.0f});
    add(scene, mesh, m);
    return scene;
}

// Light of a code from 0 to 1. [IEC 61966-2-1 for sRGB]
float light_of(double code, TexelTransfer transfer)
{
    if (transfer == TexelTransfer::none)
        return static_cast<float>(code);
    return static_cast<float>(transfer == TexelTransfer::srgb ? std::pow((code + 0.055) / 1.055, 2.4)
                                                              : std::pow(code, 2.2));
}

void expect_slots_by(const Draw& draw, TexelTransfer transfer)
{
    const scene::Scene scene = all_slots();
    Settings settings = layered(5, 5);
    settings.texel_transfer = transfer;
    const Frame frame = draw(scene, nullptr, settings);
    const auto light = [&](double code) { return light_of(code, transfer); };
    const vec3 base(0.5f * 0.9f * light(0.2), 1.0f * 0.8f * light(0.4),
                    0.25f * 0.7f * light(0.8)); // colour, factor, texel
    expect_layer(frame, "base_color", base);
    const float metalness = 0.75f * 0.8f;
    expect_layer(frame, "metalness", vec3(metalness));
    expect_layer(frame, "roughness", vec3(0.5f * 0.4f));
    expect_layer(frame, "alpha", vec3(0.04f));
    expect_layer(frame, "specular", (1.0f - metalness) * vec3(0.04f) + metalness * base);
    expect_layer(frame, "occlusion", vec3(1.0f + 0.5f * (0.4f - 1.0f)));
    expect_layer(frame, "light_emitted", {3.0f * light(0.8), 2.0f * light(0.6), 1.0f * light(0.2)});
    // Codes 153, 204, 255 are 0.2, 0.6, 1; the scale is for x and y alone.
    expect_layer(frame, "normal", glm::normalize(vec3(2.0f * 0.2f, 2.0f * 0.6f, 1.0f)));
}

} // namespace

void expect_slots(const Draw& draw)
{
    // Transfers are of colours alone.
    for (const TexelTransfer transfer :
         {TexelTransfer::none, TexelTransfer::srgb, TexelTransfer::power_2_2}) {
        SCOPED_TRACE(static_cast<int>(transfer));
        expect_slots_by(draw, transfer);
    }
}

// Of a plane that leans in its mesh, normals are those of the stretched plane, whatever the mesh's own sides say.
void expect_stretched_normals(const Draw& draw)
{
    for (const vec3& stretch : {vec3(1, 1, 1), vec3(1, 1, 3), vec3(2, 0.5f, 1), vec3(-2, 1, 0.5f)}) {
        scene::Scene scene;
        scene::Mesh mesh = facing_square(4.0f, 0.0f);
        for (vec3& position : mesh.positions)
            position.z = -0.75f * position.y + 0.5f * position.x; // z = x / 2 - 3 y / 4
        mesh.normals.assign(4, glm::normalize(vec3(-0.5f, 0.75f, 1.0f)));
        add(scene, mesh, scene::Material{}, glm::scale(glm::mat4(1.0f), stretch));
        SCOPED_TRACE(::testing::Message() << stretch.x << ' ' << stretch.y << ' ' << stretch.z);
        // z / sz = x / (2 sx) - 3 y / (4 sy)
        const vec3 wanted(-0.5f * stretch.z / stretch.x, 0.75f * stretch.z / stretch.y, 1.0f);
        expect_layer(draw(scene, nullptr, layered(5, 5)), "normal", glm::normalize(wanted));
    }
}

void expect_mirrored_normal_maps(const Draw& draw)
{
    const vec3 code(0.2f, 0.6f, 1.0f); // 153, 204, 255
    for (const float bitangent : {1.0f, -1.0f})
        for (const vec3& scale : {vec3(1, 1, 1), vec3(-1, 1, 1), vec3(1, -1, 1), vec3(-1, -1, 1)}) {
            scene::Scene scene;
            scene::Material material;
            material.normal_texture.image = 0;
            material.double_sided = true;
            scene::Mesh mesh = square_with_sets(4.0f);
            mesh.tangents.assign(4, {0.6f, 0.8f, 0.0f, bitangent});
            add(scene, mesh, material, glm::scale(glm::mat4(1.0f), scale));
            scene.images.push_back(texels({glm::ivec4{153, 204, 255, 255},
                                           {153, 204, 255, 255},
                                           {153, 204, 255, 255},
                                           {153, 204, 255, 255},
                                           {153, 204, 255, 255},
                                           {153, 204, 255, 255}}));
            // In the mesh: tangent, bitangent = w (N x T), normal. [glTF 2.0, 3.7.2.1] The mirror shows all of it mirrored.
            const vec3 in_mesh = code.x * vec3(0.6f, 0.8f, 0.0f) +
                                 code.y * bitangent * vec3(-0.8f, 0.6f, 0.0f) +
                                 code.z * vec3(0.0f, 0.0f, 1.0f);
            SCOPED_TRACE(::testing::Message() << scale.x << ' ' << scale.y << ' ' << bitangent);
            expect_layer(draw(scene, nullptr, layered(5, 5)), "normal", glm::normalize(scale * in_mesh));
        }
}

void expect_alpha_modes(const Draw& draw)
{
    struct Case {
        scene::AlphaMode mode;
        float factor, vertex;
        int code; // of the texture's alpha
        float cutoff;
        float covered; // what is wanted
    };
    using enum scene::AlphaMode;
    // 204 is 0.8: alpha is 0.8 * 0.5 * 0.9 = 0.36 at most.
    const Case cases[] = {{opaque, 0.5f, 0.9f, 204, 0.5f, 1.0f}, {blend, 0.5f, 0.9f, 204, 0.9f, 0.36f},
                          {blend, 0.5f, 1.0f, 204, 0.9f, 0.4f},  {blend, 1.0f, 1.0f, 51, 0.9f, 0.2f},
                          {mask, 0.5f, 0.9f, 204, 0.35f, 1.0f},  {mask, 0.5f, 0.9f, 204, 0.37f, 0.0f},
                          {mask, 1.0f, 1.0f, 102, 0.39f, 1.0f},  {mask, 1.0f, 1.0f, 102, 0.41f, 0.0f},
                          {mask, 0.5f, 1.0f, 255, 0.5f, 1.0f}}; // at the cutoff it is there
    for (const Case& c : cases) {
        scene::Scene scene;
        scene::Material front;
        front.unlit = true;
        front.base_color = {0.5f, 0.25f, 1.0f, c.factor};
        front.alpha_mode = c.mode;
        front.alpha_cutoff = c.cutoff;
        if (c.code < 255)
            front.base_color_texture = reading(0, 1, set_coordinates[1], 2, 1);
        scene.images.push_back(one_of(5, {255, 255, 255, c.code}));
        scene::Mesh mesh = square_with_sets(4.0f);
        mesh.colors.assign(4, {1.0f, 1.0f, 1.0f, c.vertex});
        add(scene, mesh, front, glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, 1.0f}));
        add(scene, facing_square(4.0f, 0.0f), glowing({0.0f, 2.0f, 0.5f}));
        const vec4 seen = pixel(draw(scene, nullptr, layered(5, 5)), 2, 2);
        const vec3 wanted = c.covered * vec3(0.5f, 0.25f, 1.0f) + (1.0f - c.covered) * vec3(0.0f, 2.0f, 0.5f);
        SCOPED_TRACE(::testing::Message()
                     << "mode " << static_cast<int>(c.mode) << ", alpha " << c.factor * c.vertex
                     << " times code " << c.code << ", cutoff " << c.cutoff);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(seen[i], wanted[i], 1e-5f);
        EXPECT_NEAR(seen.a, 1.0f, 1e-6f);
    }
}

void expect_panes_in_order(const Draw& draw)
{
    // From the front: each takes its alpha of what the ones before have left.
    const vec4 panes[] = {{1.0f, 0.0f, 0.0f, 0.6f},
                          {0.0f, 1.0f, 0.0f, 0.7f},
                          {0.0f, 0.0f, 1.0f, 0.9f},
                          {8.0f, 4.0f, 2.0f, 0.75f}};
    constexpr float sky = 30.0f;
    scene::Scene scene;
    vec3 wanted(0.0f);
    float left = 1.0f, depth = 4.0f;
    for (const vec4& pane : panes) {
        scene::Material material;
        material.unlit = true;
        material.base_color = pane;
        material.alpha_mode = scene::AlphaMode::blend;
        add(scene, facing_square(4.0f, 0.0f), material, glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, depth}));
        depth -= 0.01f; // as near to each other as a sheet to its coat
        wanted += left * pane.a * vec3(pane);
        left *= 1.0f - pane.a;
    }
    // 0.003 are left: three times the least that is followed. In the file they need not be sorted.
    std::swap(scene.instances[0], scene.instances[2]);
    std::swap(scene.instances[1], scene.instances[3]);
    ASSERT_NEAR(left, 0.003f, 1e-6f);
    Settings settings = layered(5, 5);
    settings.background.kind = Background::Kind::color;
    settings.background.color = vec3(sky);
    const vec4 seen = pixel(draw(scene, nullptr, settings), 2, 2);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(seen[c], wanted[c] + left * sky, 2e-5f) << c;
    EXPECT_NEAR(seen.a, 1.0f - left, 1e-6f);
    // Clear panes, more than are looked through: behind the last one that is, there is the background.
    scene::Scene clear;
    scene::Material nothing;
    nothing.alpha_mode = scene::AlphaMode::blend;
    nothing.base_color.a = 0.0f;
    add(clear, facing_square(4.0f, 0.0f), nothing);
    for (int i = 1; i < 300; ++i)
        clear.instances.push_back(
            {0, -1, glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, -0.01f * static_cast<float>(i)})});
    Settings small = small_settings(2, 2, front_camera(2.0f));
    small.background = settings.background;
    EXPECT_NEAR(pixel(draw(clear, nullptr, small), 1, 1).g, sky, 1e-3f);
    // A lamp behind all of them is a surface: it covers what was left.
    add(scene, facing_square(4.0f, 0.0f), glowing(vec3(sky)));
    const vec4 behind = pixel(draw(scene, nullptr, settings), 2, 2);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(behind[c], wanted[c] + left * sky, 2e-5f) << c;
    EXPECT_NEAR(behind.a, 1.0f, 1e-6f);
}

} // namespace lambent::draw::testing
