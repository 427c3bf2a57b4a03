// Inside a closed sphere that glows, light after each number of bounces is known.
#include "tests/reference/closed_phong.h"
#include "tests/reference/traced.h"

#include <functional>
#include <vector>

namespace lambent::reference {
namespace {

using namespace testing;

// From the middle, walls of unit glow. All sight is along the normal.
Result inside(scene::Material wall, view::Model model, int bounces)
{
    wall.double_sided = true;
    wall.emissive = glm::vec3(1.0f);
    Settings settings = small_settings(16, 0.0f, 64);
    settings.camera.position = glm::vec3(0.0f);
    settings.camera.vertical_fov = 1.0f;
    settings.model = model;
    settings.bounces = bounces;
    return trace(scene_of(scene::make_sphere(1.0f, 128, 64), wall), nullptr, settings);
}

using Brdf = std::function<double(const glm::dvec3& view, const glm::dvec3& light)>; ///< normal +Z

// The same by quadrature, after 0 to `most` bounces. In a sphere light arrives at the angle to the normal that it left
// with, and by symmetry all points are alike: radiance is a function of that cosine alone, one bounce an integral.
std::vector<double> bounced(const Brdf& brdf, int most)
{
    constexpr int panels = 32, turns = 64;
    std::vector<double> cosine; // Gauss of two points a panel; the last is the camera's
    for (int i = 0; i < panels; ++i)
        for (const double side : {-0.5, 0.5})
            cosine.push_back((i + 0.5 + side / std::sqrt(3.0)) / panels);
    const std::size_t count = cosine.size();
    cosine.push_back(1.0);
    const auto direction = [](double z, double phi) {
        const double sine = std::sqrt(1.0 - z * z);
        return glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), z);
    };
    std::vector<std::vector<double>> kernel(cosine.size(), std::vector<double>(count, 0.0));
    for (std::size_t out = 0; out < cosine.size(); ++out)
        for (std::size_t in = 0; in < count; ++in)
            for (int k = 0; k < turns; ++k)
                kernel[out][in] +=
                    brdf(direction(cosine[out], 0.0), direction(cosine[in], 2.0 * pi * (k + 0.5) / turns)) *
                    cosine[in] * (2.0 * pi / turns) * (0.5 / panels);
    std::vector<double> radiance(cosine.size(), 1.0), seen = {1.0};
    for (int bounce = 1; bounce <= most; ++bounce) {
        std::vector<double> next(cosine.size(), 1.0);
        for (std::size_t out = 0; out < cosine.size(); ++out)
            for (std::size_t in = 0; in < count; ++in)
                next[out] += kernel[out][in] * radiance[in];
        radiance = next;
        seen.push_back(radiance.back());
    }
    return seen;
}

constexpr int counts[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 30};

// The witness itself: of a matte wall it is the geometric series.
TEST(ReferenceEnclosure, QuadratureGivesTheGeometricSeries)
{
    const std::vector<double> seen =
        bounced([](const glm::dvec3&, const glm::dvec3&) { return 0.7 / pi; }, 30);
    for (const int bounces : counts)
        EXPECT_NEAR(seen[static_cast<std::size_t>(bounces)], (1.0 - std::pow(0.7, bounces + 1)) / 0.3, 1e-9);
}

// A dark wall's longer paths rarely go on: what those that do are worth makes up for it.
TEST(ReferenceEnclosure, EveryBounceAddsWhatQuadratureDoes)
{
    for (const double diffuse : {0.2, 0.6, 0.9}) {
        const ClosedPhong wall{diffuse, 0.0, 4.0};
        const std::vector<double> expected = bounced(
            [&](const glm::dvec3& view, const glm::dvec3& light) {
                return wall.brdf({0.0, 0.0, 1.0}, view, light);
            },
            30);
        for (const int bounces : counts) {
            SCOPED_TRACE(::testing::Message() << diffuse << ", bounces " << bounces);
            const glm::vec3 Kd(static_cast<float>(diffuse));
            const Result result = inside(phong(Kd, glm::vec3(0.0f), 4.0f), view::Model::phong, bounces);
            expect_light(result, glm::dvec3(expected[static_cast<std::size_t>(bounces)]), 5e-4);
        }
    }
}

// A white metal loses nothing: each bounce adds as much as there was. Rougher ones are left out: compensation makes
// single bounces worth up to twice their light, and the product of 30 has no useful variance.
TEST(ReferenceEnclosure, WhiteMetalKeepsAllLight)
{
    for (const float roughness : {0.3f, 0.7f})
        for (const int bounces : counts) {
            SCOPED_TRACE(::testing::Message() << roughness << ", bounces " << bounces);
            const Result result = inside(metallic(1.0f, 1.0f, roughness), view::Model::ggx, bounces);
            // The table's error comes in at every bounce.
            expect_light(result, glm::dvec3(bounces + 1.0), 1e-3 + 5e-4 * bounces);
        }
}

} // namespace
} // namespace lambent::reference
