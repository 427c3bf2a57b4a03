// Points and lines as triangles: how wide, how long, which way they face, and where they end; by a projection of our own.
#include "tests/draw/line_scenes.h"
#include "view/thin_shapes.h"
#include "view/widened_scene.h"

#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace lambent::draw::testing {
namespace {

constexpr int width = 200, height = 100;
constexpr double wide = 1.0 + 1.0 / 128.0; // pixels

// Where a camera sees a point, in pixels, and how far in front of it that is, in metres.
glm::dvec3 seen(const Camera& camera, const glm::vec3& point)
{
    const glm::dvec3 p = glm::dvec3(point) - glm::dvec3(camera.position);
    const double x = glm::dot(p, glm::dvec3(camera.right)), y = glm::dot(p, glm::dvec3(camera.up)),
                 depth = -glm::dot(p, glm::dvec3(camera.back));
    const double half = camera.vertical_fov > 0.0f
                            ? depth * std::tan(static_cast<double>(camera.vertical_fov) / 2.0)
                            : static_cast<double>(camera.vertical_size) / 2.0;
    return {width / 2.0 + x / half * height / 2.0, height / 2.0 - y / half * height / 2.0, depth};
}

glm::vec3 at(const Camera& camera, double x, double y, double depth)
{
    const double half = depth * std::tan(static_cast<double>(camera.vertical_fov) / 2.0);
    return camera.position + static_cast<float>((x - width / 2.0) / height * 2.0 * half) * camera.right -
           static_cast<float>((y - height / 2.0) / height * 2.0 * half) * camera.up -
           static_cast<float>(depth) * camera.back;
}

scene::Mesh thin(const scene::Mesh& mesh, const Camera& camera, const glm::mat4& transform = glm::mat4(1.0f))
{
    return view::ThinShapes(ray_map(camera, width, height), width, height).of(mesh, transform);
}

// Twice the area of a triangle in the picture; positive where its front is seen.
double doubled_area(const Camera& camera, const scene::Mesh& mesh, const glm::uvec3& triangle)
{
    const glm::dvec3 a = seen(camera, mesh.positions[triangle.x]),
                     b = seen(camera, mesh.positions[triangle.y]),
                     c = seen(camera, mesh.positions[triangle.z]);
    return (c.x - a.x) * (b.y - a.y) - (b.x - a.x) * (c.y - a.y);
}

double area(const Camera& camera, const scene::Mesh& mesh)
{
    double sum = 0.0;
    for (const glm::uvec3& triangle : mesh.triangles) {
        EXPECT_GT(doubled_area(camera, mesh, triangle), 0.0);
        sum += 0.5 * doubled_area(camera, mesh, triangle);
    }
    return sum;
}

TEST(ThinShapes, ALineIsAsLongAsItIsSeenAndAPixelWide)
{
    const Camera camera = odd_camera();
    for (int i = 0; i < 12; ++i) {
        const double turn = 0.3 + 0.5236 * i, x = 60.0 * std::cos(turn), y = 40.0 * std::sin(turn);
        // From a metre to a hundred away.
        const scene::Mesh strip =
            thin(line(at(camera, 100.0, 50.0, 1.0), at(camera, 100.0 + x, 50.0 + y, 100.0)), camera);
        ASSERT_EQ(strip.triangles.size(), 2u);
        EXPECT_NEAR(area(camera, strip), std::hypot(x, y) * wide, 2e-3 * std::hypot(x, y));
        // Both ends are as wide, and as far away as the line's.
        const std::vector<glm::vec3>& p = strip.positions;
        for (std::size_t end : {0u, 2u}) {
            const glm::dvec3 a = seen(camera, p[end]), b = seen(camera, p[end + 1]);
            EXPECT_NEAR(glm::length(glm::dvec2(a) - glm::dvec2(b)), wide, 2e-3);
            EXPECT_NEAR(a.z, end == 0 ? 1.0 : 100.0, 1e-3);
            EXPECT_NEAR(b.z, a.z, 1e-4 * a.z);
        }
    }
}

TEST(ThinShapes, APointIsAPixel)
{
    for (const Camera& camera : {odd_camera(), front_camera(3.0f)}) {
        const glm::vec3 place =
            camera.vertical_fov > 0.0f ? at(camera, 31.3, 70.8, 9.0) : glm::vec3(0.4f, 0.2f, 1.0f);
        const glm::dvec3 middle = seen(camera, place);
        const scene::Mesh square = thin(points({place}), camera);
        EXPECT_NEAR(area(camera, square), wide * wide, 1e-3);
        for (const glm::vec3& corner : square.positions) {
            EXPECT_NEAR(std::fabs(seen(camera, corner).x - middle.x), wide / 2.0, 1e-3);
            EXPECT_NEAR(std::fabs(seen(camera, corner).y - middle.y), wide / 2.0, 1e-3);
        }
    }
}

// From 7 m behind the camera to 9 m in front of it: what is in front is drawn, up to the picture's border. The colour goes
// with the line's metres, not with its pixels.
TEST(ThinShapes, LinesAreCutWhereTheyLeaveThePicture)
{
    Camera camera = front_camera(0.0f, 0.0f);
    camera.vertical_fov = 1.5707963f; // a metre away, half a picture is a metre high
    scene::Mesh mesh = line({0.0f, -1.0f, 7.0f}, {0.0f, 1.0f, -9.0f});
    mesh.colors = {{0, 0, 0, 1}, {1, 1, 1, 1}};
    const scene::Mesh strip = thin(mesh, camera);
    ASSERT_EQ(strip.positions.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec3 p = strip.positions[i];
        EXPECT_LT(p.z, 0.0f);
        // y = -1 + 2 s, z = 7 - 16 s
        const float part = (7.0f - p.z) / 16.0f;
        EXPECT_NEAR(p.y, -1.0f + 2.0f * part, 1e-4f);
        EXPECT_NEAR(strip.colors[i].r, part, 1e-4f);
    }
    // The lower border, and two pixels more, are where y = 1.04 z: s = 8.28 / 18.64.
    EXPECT_NEAR(strip.colors[0].r, 8.28f / 18.64f, 1e-4f);
    EXPECT_EQ(strip.colors[3].r, 1.0f);
    const glm::mat4 behind = glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, 20.0f});
    EXPECT_TRUE(thin(mesh, camera, behind).triangles.empty());
    EXPECT_TRUE(thin(points({{0, 0, 1}, {50, 0, -1}}), camera).triangles.empty());
    // Straight at the camera it has no length.
    EXPECT_TRUE(thin(line({0, 0, -1}, {0, 0, -2}), camera).triangles.empty());
    // Without perspective the camera's own plane is the border.
    mesh.positions = {{0.0f, 0.0f, 3.0f}, {0.0f, 1.0f, -1.0f}};
    const scene::Mesh flat = thin(mesh, front_camera(4.0f, 1.0f));
    EXPECT_NEAR(flat.positions[0].z, 1.0f, 1e-5f);
    EXPECT_NEAR(flat.colors[0].r, 0.5f, 1e-5f);
}

TEST(ThinShapes, NormalsAreOfTheWorldAndOnTheSideThatIsSeen)
{
    scene::Mesh mesh = line({-1, 0, 0}, {1, 0, 0});
    const Camera camera = front_camera(4.0f);
    for (const glm::vec3& normal : thin(mesh, camera).normals)
        EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    mesh.normals.assign(2, glm::normalize(glm::vec3(0.0f, 1.0f, 1.0f)));
    // Twice as high: the normal leans back. (0, 1/2, 1) / |...|
    const glm::mat4 high = glm::scale(glm::mat4(1.0f), {1.0f, 2.0f, 1.0f});
    EXPECT_NEAR(thin(mesh, camera, high).normals[0].y, 1.0f / std::sqrt(5.0f), 1e-6f);
    EXPECT_NEAR(thin(mesh, camera, high).normals[0].z, 2.0f / std::sqrt(5.0f), 1e-6f);
    const glm::mat4 turned = glm::rotate(glm::mat4(1.0f), 3.14159265f, {0.0f, 1.0f, 0.0f});
    EXPECT_NEAR(thin(mesh, camera, turned).normals[0].y, -std::sqrt(0.5f), 1e-6f);
    EXPECT_NEAR(thin(mesh, camera, turned).normals[0].z, std::sqrt(0.5f), 1e-6f);
    // Turned round are all three of normal, tangent and cross(normal, tangent) * w.
    mesh.tangents.assign(2, {1, 0, 0, 1});
    EXPECT_EQ(thin(mesh, camera, high).tangents[0], glm::vec4(1, 0, 0, 1));
    EXPECT_NEAR(thin(mesh, camera, turned).tangents[0].x, 1.0f, 1e-6f);
    EXPECT_EQ(thin(mesh, camera, turned).tangents[0].w, -1.0f);
    const glm::mat4 mirrored = glm::scale(glm::mat4(1.0f), {-1.0f, 1.0f, 1.0f});
    EXPECT_EQ(thin(mesh, camera, mirrored).tangents[0], glm::vec4(-1, 0, 0, -1));
}

// Of a camera that is no camera nothing is made, rather than numbers that are none.
TEST(ThinShapes, OfNoVolumeNothingIsMade)
{
    Camera camera = front_camera(0.0f);
    EXPECT_TRUE(thin(line({-1, 0, 0}, {1, 0, 0}), camera).triangles.empty());
    camera = odd_camera();
    camera.position.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(thin(line({-1, 0, 0}, {1, 0, 0}), camera).triangles.empty());
}

// Each instance of one mesh faces the camera by itself; what is not lines stays, or does not.
TEST(WidenedScene, HasAMeshForEachInstance)
{
    scene::Scene scene = scene_of(line({0, 0, 0}, {1, 0, 0}), line_material(glm::vec3(1.0f)));
    add(scene, facing_square(1.0f, 0.0f), {});
    scene.instances.push_back({0, 1, glm::translate(glm::mat4(1.0f), {0.0f, 1.0f, 0.0f})});
    const Settings settings = small_settings(width, height, front_camera(10.0f));
    for (const bool others : {true, false}) {
        view::WidenedScene widened(scene, others ? view::WidenedScene::Others::shown
                                                 : view::WidenedScene::Others::left_out);
        EXPECT_TRUE(widened.face(settings));
        EXPECT_FALSE(widened.face(settings));
        const scene::Scene& made = widened.scene();
        EXPECT_FALSE(has_lines(made));
        EXPECT_EQ(triangle_count(made), others ? 6u : 4u);
        ASSERT_EQ(made.instances.size(), 3u);
        EXPECT_EQ(made.instances[2].material, 1);
        const scene::Mesh& second = made.meshes.at(static_cast<std::size_t>(made.instances[2].mesh));
        EXPECT_NEAR(second.positions.at(0).y + second.positions.at(1).y, 2.0f, 1e-4f);
        EXPECT_EQ(second.material, 0);
    }
}

} // namespace
} // namespace lambent::draw::testing
