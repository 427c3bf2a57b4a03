#include "tests/support/random_scene.h"

#include "scene/builtin/shapes.h"
#include "tests/support/random_numbers.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lambent::testing {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

scene::Mesh flat(std::vector<glm::vec3> corners, std::vector<glm::uvec3> triangles, const glm::vec3& normal)
{
    scene::Mesh mesh;
    mesh.normals.assign(corners.size(), normal);
    mesh.positions = std::move(corners);
    mesh.triangles = std::move(triangles);
    return mesh;
}

scene::Mesh square()
{
    return flat({{-0.5f, -0.5f, 0.0f}, {0.5f, -0.5f, 0.0f}, {0.5f, 0.5f, 0.0f}, {-0.5f, 0.5f, 0.0f}},
                {{0, 1, 2}, {0, 2, 3}}, {0.0f, 0.0f, 1.0f});
}

void append(scene::Mesh& whole, const scene::Mesh& part)
{
    const auto first = static_cast<unsigned>(whole.positions.size());
    whole.positions.insert(whole.positions.end(), part.positions.begin(), part.positions.end());
    whole.normals.insert(whole.normals.end(), part.normals.begin(), part.normals.end());
    for (const glm::uvec3& triangle : part.triangles)
        whole.triangles.push_back(triangle + first);
}

// A box of unit sides whose first `sides` are there: 6 is closed.
scene::Mesh box(int sides)
{
    scene::Mesh whole;
    for (int side = 0; side < sides; ++side) {
        scene::Mesh part = square();
        const int axis = side / 2, next = (axis + 1) % 3, last = (axis + 2) % 3;
        const float sign = side % 2 == 0 ? 1.0f : -1.0f;
        for (glm::vec3& p : part.positions) {
            const glm::vec3 old = p;
            p[axis] = 0.5f * sign, p[next] = old.x * sign, p[last] = old.y;
        }
        glm::vec3 normal(0.0f);
        normal[axis] = sign;
        part.normals.assign(4, normal);
        append(whole, part);
    }
    return whole;
}

scene::Mesh triangles(RandomNumbers& random)
{
    scene::Mesh whole;
    for (int count = 1 + random.below(3); count > 0; --count) {
        const glm::vec3 a = random.in_box(glm::vec3(0.5f)), b = random.in_box(glm::vec3(0.5f)),
                        c = random.in_box(glm::vec3(0.5f));
        append(whole, flat({a, b, c}, {{0, 1, 2}}, glm::normalize(glm::cross(b - a, c - a))));
    }
    return whole;
}

scene::Mesh shape(RandomNumbers& random, std::string& words)
{
    switch (random.below(6)) {
    case 0:
        words += " triangles";
        return triangles(random);
    case 1:
        words += " square";
        return square();
    case 2:
        words += " box";
        return box(6);
    case 3:
        words += " open_box";
        return box(5);
    case 4:
        words += " coarse_ball";
        return scene::make_sphere(0.5f, 8, 5);
    default:
        words += " ball";
        return scene::make_sphere(0.5f, 32, 16);
    }
}

void choose_alpha(RandomNumbers& random, scene::Material& material, std::string& words)
{
    if (random.chance(0.7f))
        return;
    if (random.chance(0.4f)) {
        material.alpha_mode = scene::AlphaMode::mask;
        material.base_color.a = random.from(0.6f, 1.0f);
        words += " mask";
    } else {
        material.alpha_mode = scene::AlphaMode::blend;
        material.base_color.a = random.from(0.1f, 0.9f);
        words += " blend";
    }
}

// Highlights of lights without size on smoother surfaces are points that a path tracer meets too rarely.
float least_roughness(const scene::Scene& scene)
{
    return scene.lights.empty() ? 0.0f : 0.25f;
}

scene::Material material(RandomNumbers& random, float smoothest, std::string& words)
{
    scene::Material m;
    m.base_color = glm::vec4(random.color(0.1f, 0.9f), 1.0f);
    m.metallic = random.chance(0.4f) ? 1.0f : random.chance(0.8f) ? 0.0f : random.from(0.0f, 1.0f);
    m.perceptual_roughness = random.chance(0.15f) ? smoothest : random.from(std::max(smoothest, 0.1f), 1.0f);
    words += m.metallic > 0.0f ? " metal" : " dielectric";
    words += m.perceptual_roughness < 0.3f ? " smooth" : " rough";
    choose_alpha(random, m, words);
    m.double_sided = random.chance(0.5f);
    if (m.double_sided)
        words += " two_sided";
    if (random.chance(0.12f)) {
        m.emissive = random.color(0.2f, 2.0f);
        words += " emissive";
    }
    if (random.chance(0.04f)) {
        m.unlit = true;
        words += " unlit";
    }
    if (random.chance(0.12f)) {
        m.coat = random.from(0.3f, 1.0f);
        m.coat_roughness = random.from(smoothest, 0.6f);
        words += " coat";
    }
    return m;
}

void place(scene::Scene& scene, RandomNumbers& random, int mesh)
{
    const glm::vec3 place = random.in_box(glm::vec3(0.6f)), axis = random.direction();
    glm::mat4 transform = glm::rotate(glm::translate(glm::mat4(1.0f), place), random.from(0.0f, pi), axis);
    glm::vec3 size = random.color(0.3f, 1.2f);
    if (random.chance(0.3f))
        size = glm::vec3(size.x);
    if (random.chance(0.25f))
        size.x = -size.x;
    scene.instances.push_back({mesh, -1, glm::scale(transform, size)});
}

void turn_inside_out(scene::Mesh& mesh)
{
    for (glm::uvec3& triangle : mesh.triangles)
        std::swap(triangle.y, triangle.z);
    for (glm::vec3& normal : mesh.normals)
        normal = -normal;
}

// A floor, or a room of five walls, or nothing.
void add_surroundings(scene::Scene& scene, RandomNumbers& random, std::string& words)
{
    const float kind = random.from(0.0f, 1.0f);
    if (kind > 0.75f)
        return;
    words += kind < 0.15f ? " | room:" : " | floor:";
    std::string unused;
    scene::Material m = material(random, least_roughness(scene), unused);
    m.emissive = glm::vec3(0.0f), m.unlit = false, m.alpha_mode = scene::AlphaMode::opaque;
    words += m.metallic > 0.0f ? " metal" : " dielectric";
    glm::mat4 transform(1.0f);
    scene::Mesh mesh;
    if (kind < 0.15f) {
        mesh = box(5);
        turn_inside_out(mesh);
        transform = glm::scale(transform, glm::vec3(2.6f));
    } else {
        mesh = square();
        transform = glm::translate(transform, {0.0f, -0.8f, 0.0f});
        transform = glm::rotate(transform, -0.5f * pi, {1.0f, 0.0f, 0.0f});
        transform = glm::scale(transform, glm::vec3(4.0f));
    }
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(m);
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), -1, transform});
    scene.meshes.push_back(std::move(mesh));
}

void add_shapes(scene::Scene& scene, RandomNumbers& random, std::string& words)
{
    for (int count = 1 + random.below(4); count > 0; --count) {
        words += " |";
        scene::Mesh mesh = shape(random, words);
        if (random.chance(0.2f)) {
            words += " coloured";
            for (std::size_t i = 0; i < mesh.positions.size(); ++i)
                mesh.colors.emplace_back(random.color(0.2f, 1.0f), random.from(0.3f, 1.0f));
        }
        mesh.material = static_cast<int>(scene.materials.size());
        scene.materials.push_back(material(random, least_roughness(scene), words));
        const auto index = static_cast<int>(scene.meshes.size());
        scene.meshes.push_back(std::move(mesh));
        for (int copies = random.chance(0.3f) ? 2 : 1; copies > 0; --copies)
            place(scene, random, index);
    }
}

scene::Light light(RandomNumbers& random, std::string& words)
{
    scene::Light l;
    if (random.chance(0.34f)) {
        l.kind = scene::LightKind::directional;
        l.direction = random.direction();
        l.direction.y = -std::fabs(l.direction.y);
        l.intensity = random.color(0.5f, 3.0f);
        words += " sun";
        return l;
    }
    l.position = 1.6f * random.direction();
    l.intensity = random.color(1.0f, 5.0f);
    words += " lamp";
    if (random.chance(0.5f)) {
        l.kind = scene::LightKind::spot;
        l.direction = glm::normalize(0.4f * random.direction() - l.position);
        l.outer_cone = random.from(0.2f, 1.2f);
        l.inner_cone = random.from(0.0f, 0.9f) * l.outer_cone;
        words += " spot";
    }
    if (random.chance(0.2f))
        l.range = random.from(1.5f, 4.0f);
    return l;
}

// A gradient, and sometimes a few soft lamps.
image::RadianceImage panorama(RandomNumbers& random, bool dark, std::string& words)
{
    constexpr int width = 64, height = 32;
    image::RadianceImage image{width, height, 3, std::vector<float>(width * height * 3)};
    if (dark)
        return image;
    const glm::vec3 above = random.color(0.2f, 1.0f), way = random.direction();
    const int lamps = random.below(3);
    glm::vec3 towards[2], glow[2];
    float width_of[2];
    for (int i = 0; i < lamps; ++i)
        towards[i] = random.direction(), glow[i] = random.color(2.0f, 20.0f),
        width_of[i] = random.from(0.1f, 0.4f);
    words += lamps > 0 ? " lamps" : " gradient";
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float phi = ((static_cast<float>(x) + 0.5f) / width - 0.5f) * 2.0f * pi,
                        theta = (static_cast<float>(y) + 0.5f) / height * pi;
            const glm::vec3 d(std::sin(theta) * std::cos(phi), std::cos(theta),
                              std::sin(theta) * std::sin(phi));
            glm::vec3 radiance = above * (1.0f + 0.8f * glm::dot(d, way));
            for (int i = 0; i < lamps; ++i)
                radiance +=
                    glow[i] * std::exp((glm::dot(d, towards[i]) - 1.0f) / (width_of[i] * width_of[i]));
            for (int c = 0; c < 3; ++c)
                image.pixel(x, y)[c] = radiance[c];
        }
    return image;
}

view::Camera camera(RandomNumbers& random)
{
    view::Camera c;
    glm::vec3 away = random.direction();
    away.y = random.from(-0.1f, 0.8f);
    const float distance = random.from(2.0f, 3.5f);
    c.back = glm::normalize(away);
    c.right = glm::normalize(glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), c.back));
    c.up = glm::cross(c.back, c.right);
    c.position = distance * c.back + random.in_box(glm::vec3(0.2f));
    if (random.chance(0.25f)) {
        c.vertical_fov = 0.0f;
        c.vertical_size = random.from(0.8f, 2.5f);
    } else {
        c.vertical_fov = random.from(0.3f, 0.9f);
    }
    return c;
}

} // namespace

RandomScene random_scene(std::uint32_t number, int width, int height)
{
    RandomNumbers random(number);
    RandomScene made;
    made.dark = random.chance(0.15f);
    made.words = made.dark ? "dark" : "";
    made.panorama = panorama(random, made.dark, made.words);
    const int lights = made.dark ? 1 + random.below(2) : std::max(random.below(5) - 2, 0);
    for (int i = 0; i < lights; ++i)
        made.scene.lights.push_back(light(random, made.words));
    add_surroundings(made.scene, random, made.words);
    add_shapes(made.scene, random, made.words);
    made.picture.width = width;
    made.picture.height = height;
    made.picture.camera = camera(random);
    made.picture.background.kind = view::Background::Kind::none;
    made.picture.environment_rotation = random.chance(0.3f) ? random.from(-pi, pi) : 0.0f;
    made.picture.energy_compensation = random.chance(0.9f);
    made.bounces = 1 + random.below(4);
    return made;
}

} // namespace lambent::testing
