#include "scene/builtin/builtin.h"

#include "base/error.h"
#include "base/text.h"
#include "equations/in_double.h"
#include "scene/builtin/painted_textures.h"
#include "scene/builtin/shapes.h"
#include "scene/builtin/teapot.h"

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace lambent::scene {
namespace {

constexpr std::array<std::string_view, 7> names = {"sphere",  "teapot", "plane",  "report",
                                                   "painted", "grid",   "furnace"};

constexpr float highest_exponent = 1e6f;

int scaled(int usual, const BuiltinOptions& options)
{
    return std::max(3, static_cast<int>(std::lround(usual * static_cast<double>(options.density))));
}

Material ggx_material(glm::vec3 base_color, float metallic, float perceptual_roughness)
{
    Material material;
    material.base_color = glm::vec4(base_color, 1.0f);
    material.metallic = metallic;
    material.perceptual_roughness = perceptual_roughness;
    return material;
}

// A material of the report.
struct ReportMaterial {
    glm::vec3 diffuse, specular;
    float exponent;
};

// The report's parameters for the Phong model, and the closest dielectric for the metallic-roughness model.
Material report_material(const char* name, const ReportMaterial& report)
{
    const double alpha = in_double::phong_alpha(static_cast<double>(report.exponent));
    Material material = ggx_material(report.diffuse, 0.0f, static_cast<float>(std::sqrt(alpha)));
    material.name = name;
    material.phong = {report.diffuse, report.specular, report.exponent};
    return material;
}

void add(Scene& scene, Mesh mesh, Material material, const glm::mat4& transform)
{
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(std::move(material));
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), -1, transform});
    scene.meshes.push_back(std::move(mesh));
}

glm::mat4 moved(float x, float y, float z)
{
    return glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z));
}

Scene make_sphere_scene(const BuiltinOptions& options)
{
    constexpr float radius = 0.5f;
    Material paint = ggx_material({0.75f, 0.08f, 0.06f}, 0.0f, 0.25f);
    paint.name = "paint";
    paint.phong = {glm::vec3(0.75f, 0.08f, 0.06f), glm::vec3(0.2f), 100.0f};
    Scene scene;
    add(scene, make_sphere(radius, scaled(256, options), scaled(128, options)), paint,
        moved(0.0f, radius, 0.0f));
    return scene;
}

Scene make_teapot_scene(const BuiltinOptions& options)
{
    Material glaze = ggx_material(glm::vec3(0.8f), 0.0f, 0.2f);
    glaze.name = "glaze";
    glaze.phong = {glm::vec3(0.8f), glm::vec3(0.2f), 100.0f};
    glaze.double_sided = true; // the spout is open
    Scene scene;
    add(scene, make_teapot(scaled(32, options)), glaze, glm::mat4(1.0f));
    return scene;
}

Material grey_ground()
{
    Material ground = ggx_material(glm::vec3(0.5f), 0.0f, 0.3f);
    ground.name = "ground";
    ground.double_sided = true;
    return ground;
}

Scene make_plane_scene(const BuiltinOptions& options)
{
    Scene scene;
    add(scene, make_plane(1.0f, scaled(4, options)), grey_ground(), glm::mat4(1.0f));
    return scene;
}

Light directional(glm::vec3 towards, glm::vec3 lux)
{
    Light light;
    light.kind = LightKind::directional;
    light.intensity = lux;
    light.direction = glm::normalize(towards);
    return light;
}

Light point(glm::vec3 position, glm::vec3 candela)
{
    Light light;
    light.kind = LightKind::point;
    light.intensity = candela;
    light.position = position;
    return light;
}

Scene make_report_scene(const BuiltinOptions& options)
{
    constexpr float exponent = 100.0f;
    constexpr float sphere_radius = 0.22f;
    Scene scene;
    add(scene, make_sphere(sphere_radius, scaled(256, options), scaled(128, options)),
        report_material("sphere", {{0.6f, 0.1f, 0.08f}, glm::vec3(0.25f), exponent}),
        moved(-0.42f, sphere_radius, 0.0f));
    Material glaze = report_material("teapot", {{0.1f, 0.25f, 0.55f}, glm::vec3(0.25f), exponent});
    glaze.double_sided = true;
    add(scene, make_teapot(scaled(32, options)), glaze,
        glm::scale(moved(0.38f, 0.0f, 0.0f), glm::vec3(2.6f)));
    Material ground = report_material("plane", {glm::vec3(0.4f), glm::vec3(0.3f), exponent});
    ground.double_sided = true;
    add(scene, make_plane(0.95f, scaled(4, options)), ground, glm::mat4(1.0f));

    scene.lights.push_back(directional({0.5f, -0.8f, -0.55f}, glm::vec3(1.0f)));
    // Low over the plane, so that highlights seen from the front stretch into streaks.
    scene.lights.push_back(point({-0.1f, 0.12f, 0.5f}, glm::vec3(0.06f, 0.028f, 0.006f)));
    scene.lights.push_back(point({0.75f, 0.15f, 0.4f}, glm::vec3(0.008f, 0.026f, 0.06f)));
    return scene;
}

// A material of the report with a texture as its diffuse colour.
Material textured(const char* name, int image)
{
    Material material = report_material(name, {glm::vec3(1.0f), glm::vec3(0.2f), 100.0f});
    material.phong.diffuse.reset();
    material.base_color_texture.image = image;
    return material;
}

Scene make_painted_scene(const BuiltinOptions& options)
{
    constexpr float radius = 0.5f;
    Scene scene;
    scene.images = {color_chart(), floor_tiles()};
    add(scene, make_sphere(radius, scaled(256, options), scaled(128, options)), textured("chart", 0),
        moved(0.0f, radius, 0.0f));
    Material floor = textured("tiles", 1);
    floor.double_sided = true;
    constexpr float half_size = 1.0f, tile_size = 0.25f;
    floor.base_color_texture.transform = glm::mat3(half_size / tile_size);
    floor.base_color_texture.transform[2][2] = 1.0f;
    add(scene, make_plane(half_size, scaled(4, options)), floor, glm::mat4(1.0f));
    return scene;
}

// Spheres of one colour in the XY plane, centred: roughness grows to the right, metallic upwards.
struct SphereGrid {
    glm::vec3 base_color{1.0f};
    int columns = 1;
    int rows = 1;
    int segments = 64;
    int rings = 32;
};

Scene make_sphere_grid(const SphereGrid& grid)
{
    constexpr float radius = 0.1f;
    constexpr float spacing = 2.5f * radius;
    Scene scene;
    scene.meshes.push_back(make_sphere(radius, grid.segments, grid.rings));
    const auto share = [](int index, int count) {
        return static_cast<float>(index) / static_cast<float>(count - 1);
    };
    const auto offset = [](int index, int count) {
        return (static_cast<float>(index) - 0.5f * static_cast<float>(count - 1)) * spacing;
    };
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const int material = static_cast<int>(scene.materials.size());
            scene.materials.push_back(
                ggx_material(grid.base_color, share(row, grid.rows), share(column, grid.columns)));
            scene.materials.back().name =
                text("metallic ", share(row, grid.rows), ", roughness ", share(column, grid.columns));
            scene.instances.push_back(
                {0, material, moved(offset(column, grid.columns), offset(row, grid.rows), 0.0f)});
        }
    }
    return scene;
}

void check_options(const BuiltinOptions& options)
{
    if (!(options.density >= 1.0f / 16.0f && options.density <= 8.0f))
        throw Error(Failure::usage, text("density ", options.density, " is not between 1/16 and 8"));
    if (options.exponent && !(*options.exponent > 0.0f && *options.exponent <= highest_exponent))
        throw Error(Failure::usage, text("exponent ", *options.exponent, " is not above 0 and at most 1e6"));
    for (const auto& color : {options.diffuse, options.specular})
        if (color && !(color->x >= 0.0f && color->y >= 0.0f && color->z >= 0.0f &&
                       std::isfinite(color->x + color->y + color->z)))
            throw Error(Failure::usage, "a diffuse or specular colour is negative or not finite");
}

Scene make_plain(std::string_view name, const BuiltinOptions& options)
{
    if (name == "sphere")
        return make_sphere_scene(options);
    if (name == "teapot")
        return make_teapot_scene(options);
    if (name == "plane")
        return make_plane_scene(options);
    if (name == "report")
        return make_report_scene(options);
    if (name == "painted")
        return make_painted_scene(options);
    if (name == "grid")
        return make_sphere_grid({{1.0f, 0.766f, 0.336f}, 7, 7, scaled(38, options), scaled(20, options)});
    if (name == "furnace")
        return make_sphere_grid({glm::vec3(1.0f), 11, 3, scaled(64, options), scaled(32, options)});
    throw Error(Failure::usage, text("there is no built-in scene \"", name, "\""));
}

} // namespace

std::span<const std::string_view> builtin_names()
{
    return names;
}

bool is_builtin(std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

Scene make_builtin(std::string_view name, const BuiltinOptions& options)
{
    check_options(options);
    Scene scene = make_plain(name, options);
    for (Material& material : scene.materials) {
        if (options.diffuse)
            material.phong.diffuse = options.diffuse;
        if (options.specular)
            material.phong.specular = options.specular;
        if (options.exponent)
            material.phong.exponent = options.exponent;
    }
    return scene;
}

} // namespace lambent::scene
