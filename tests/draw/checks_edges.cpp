// Where a pixel is looked at several times, and how much of it each look stands for.
#include "tests/draw/backend_checks.h"
#include "tests/draw/test_scenes.h"
#include "tests/equations/reference_ggx.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::draw::testing {
namespace {

constexpr int size = 12; // pixels, a metre each

// A part of a mesh between x = left and right, at heights z there; grey, or a slope of grey, seen as it is.
struct Strip {
    float left, left_z, right, right_z, left_grey, right_grey;
    bool turned = false; // shows its back
};

void add_strip(const Strip& s, scene::Mesh& mesh)
{
    const auto first = static_cast<unsigned>(mesh.positions.size());
    const float half = size;
    mesh.positions.insert(mesh.positions.end(), {{s.left, -half, s.left_z},
                                                 {s.right, -half, s.right_z},
                                                 {s.right, half, s.right_z},
                                                 {s.left, half, s.left_z}});
    const glm::vec3 normal = glm::normalize(glm::vec3(s.left_z - s.right_z, 0.0f, s.right - s.left));
    mesh.normals.insert(mesh.normals.end(), 4, normal);
    for (const float grey : {s.left_grey, s.right_grey, s.right_grey, s.left_grey})
        mesh.colors.emplace_back(grey, grey, grey, 1.0f);
    const unsigned second = s.turned ? 3 : 1, last = s.turned ? 1 : 3;
    mesh.triangles.push_back({first, first + second, first + 2});
    mesh.triangles.push_back({first, first + 2, first + last});
}

// The pixel in whose first quarter the white strip ends and the black one begins, both of one mesh.
float seen_where_they_meet(const Draw& draw, const Strip& white, const Strip& black)
{
    scene::Scene scene;
    scene::Mesh mesh;
    add_strip(white, mesh);
    add_strip(black, mesh);
    scene::Material material;
    material.unlit = true;
    material.double_sided = true;
    add(scene, mesh, material);
    Settings settings = small_settings(size, size, front_camera(size));
    settings.edge_samples = 4;
    return pixel(draw(scene, nullptr, settings), size / 2, size / 2).r;
}

} // namespace

void expect_edges(const Draw& draw)
{
    constexpr float meet = 0.25f, far = size;
    // A slope black and a level white strip. The white point in the middle of the pixel to the left, at x = -0.5, is `off` widths of
    // a pixel off the plane of the black one, at x = 0.5. Looks that are lit as one, up to 15 degrees, are so in the middle.
    const auto over_a_step = [&](double degrees, double off) {
        const double angle = degrees / 180.0 * std::numbers::pi, slope = std::tan(angle);
        const double step = 0.75 * slope - off / std::cos(angle);
        return seen_where_they_meet(draw, {-far, 0.0f, meet, 0.0f, 1.0f, 1.0f},
                                    {meet, static_cast<float>(step), far,
                                     static_cast<float>(step + slope * (size - 0.25)), 0.0f, 0.0f});
    };
    for (const double degrees : {-25.0, -17.0, 17.0, 25.0})
        for (const double off : {-6.0, -1.15, -0.85, -0.1, 0.1, 0.85, 1.15, 6.0})
            EXPECT_NEAR(over_a_step(degrees, off), std::fabs(off) < 1.0 ? 0.0f : 0.25f, 1e-6f)
                << "a step of " << off << " at " << degrees << " degrees";
    for (const double off : {-6.0, 6.0})
        EXPECT_NEAR(over_a_step(13.0, off), 0.0f, 1e-6f) << off;
    // A ridge that bends by so many degrees: an edge from 30 on.
    for (const double degrees : {20.0, 28.0, 32.0, 60.0}) {
        const auto down = static_cast<float>(std::tan(0.5 * degrees / 180.0 * std::numbers::pi));
        const float seen = seen_where_they_meet(draw, {-far, -down * (far + meet), meet, 0.0f, 1.0f, 1.0f},
                                                {meet, 0.0f, far, -down * (far - meet), 0.0f, 0.0f});
        EXPECT_NEAR(seen, degrees < 30.0 ? 0.0f : 0.25f, 1e-6f) << degrees << " degrees";
    }
}

// Four looks, in the middles of four columns and of four rows. What lies behind an edge at x = 0.25 is seen at 3/8, 5/8 and
// 7/8 of the pixel, on the mean at 5/8; of these looks and the one through the middle, that one is the nearest.
void expect_looks(const Draw& draw)
{
    constexpr float far = size;
    for (const float part : {0.06f, 0.3f, 0.45f, 0.55f, 0.7f, 0.95f})
        for (const bool upright : {false, true}) {
            scene::Scene scene;
            scene::Mesh mesh = facing_square(far, 0.0f);
            for (glm::vec3& position : mesh.positions) {
                // Ends at part of the pixel from its left, or from its top.
                float& end = upright ? position.x : position.y;
                end = upright ? std::min(end, part) : std::max(end, -part);
            }
            add(scene, mesh, glowing(glm::vec3(1.0f)));
            Settings settings = small_settings(size, size, front_camera(size));
            settings.edge_samples = 4;
            const glm::vec4 seen = pixel(draw(scene, nullptr, settings), size / 2, size / 2);
            EXPECT_NEAR(seen.a, std::round(4.0f * part) / 4.0f, 1e-6f) << part << ' ' << upright;
        }
    const auto grey = [](float x) { return 0.3f + 0.02f * x; };
    const float seen =
        seen_where_they_meet(draw, {-far, 0.0f, 0.25f, 0.0f, 0.0f, 0.0f},
                             {0.25f, 6.0f, far, 6.0f + 0.4f * (far - 0.25f), grey(0.25f), grey(far)});
    EXPECT_NEAR(seen, 0.75f * grey(0.5f), 1e-5f);
    // A fold seen from its front and from its back, whose sides bend by a few degrees.
    const float steep = std::tan(86.0f / 180.0f * static_cast<float>(std::numbers::pi));
    const float folded = seen_where_they_meet(draw, {-far, -steep * (far + 0.25f), 0.25f, 0.0f, 1.0f, 1.0f},
                                              {0.25f, 0.0f, far, -steep * (far - 0.25f), 0.0f, 0.0f, true});
    EXPECT_NEAR(folded, 0.25f, 1e-6f);
}

// A mirroring sphere whose normals turn by more than six degrees from pixel to pixel is lit at every look where many samples are
// asked for, at each of 16 as a square a quarter of a pixel wide. Then alpha^2 grows by (bend / 4)^2 / 6, and the pixel
// is the mean over its places of D G2 / (4 NV NL) NL. [as DirectLight.HighlightsNarrowerThanAPixelFillIt has it]
void expect_small_highlights(const Draw& draw)
{
    constexpr int pixels = 17;
    scene::Scene scene;
    scene::Material metal;
    constexpr double alpha = 0.03;
    metal.perceptual_roughness = static_cast<float>(std::sqrt(alpha));
    add(scene, scene::make_sphere(0.5f, 192, 96), metal);
    Settings settings = small_settings(pixels, pixels, front_camera(1.0f));
    settings.energy_compensation = false;
    settings.samples = 256;
    settings.edge_samples = 16;
    scene::Light light;
    light.kind = scene::LightKind::directional;
    light.direction = {0.0f, 0.0f, -1.0f};
    settings.lights = {light};
    const double step = 1.0 / pixels, bend = 2.0 * step, wide = std::sqrt(alpha * alpha + bend * bend / 96.0);
    constexpr int places = 64;
    double sum = 0.0;
    for (int i = 0; i < places; ++i)
        for (int j = 0; j < places; ++j) {
            const double x = ((i + 0.5) / places - 0.5) * bend, y = ((j + 0.5) / places - 0.5) * bend,
                         c = std::sqrt(1.0 - x * x - y * y);
            // N is (x, y, c), V, L and H are along z.
            sum += test::facet_density(c, wide) / (1.0 + 2.0 * test::smith_lambda(c, wide)) / (4.0 * c);
        }
    const double wanted = sum / (places * places);
    const auto seen = static_cast<double>(pixel(draw(scene, nullptr, settings), pixels / 2, pixels / 2).r);
    EXPECT_NEAR(seen / wanted, 1.0, 0.08);
    // Behind a shell of glass that bends as much, every look goes on as it is.
    scene::Material glass;
    glass.unlit = true;
    glass.base_color = {0.0f, 0.0f, 0.0f, 0.5f};
    glass.alpha_mode = scene::AlphaMode::blend;
    add(scene, scene::make_sphere(0.53f, 192, 96), glass);
    const auto behind = static_cast<double>(pixel(draw(scene, nullptr, settings), pixels / 2, pixels / 2).r);
    EXPECT_NEAR(behind / (0.5 * wanted), 1.0, 0.08);
}

} // namespace lambent::draw::testing
