// Surfaces that shine as lights.
#include "tests/reference/closed_phong.h"
#include "tests/reference/traced.h"

#include <glm/ext/matrix_transform.hpp>

#include <gtest/gtest.h>

namespace lambent::reference {
namespace {

using namespace testing;

// A square of side 2 h at height d over a matte point under its middle: radiance L times the form factor
// 4 / (2 pi) (2 h' / sqrt(1 + h'^2) atan(h' / sqrt(1 + h'^2))), h' = h / d, of four right-angled quarters.
// [Howell 2010, configuration factor B-4]
TEST(Emitters, AShiningSquareOverAMattePoint)
{
    const double half = 0.7, height = 0.5, ratio = half / height, root = std::sqrt(1.0 + ratio * ratio);
    const double factor = 4.0 / (2.0 * pi) * 2.0 * ratio / root * std::atan(ratio / root);
    scene::Scene scene;
    add(scene, facing_square(0.01f, 0.0f), phong(glm::vec3(0.5f), glm::vec3(0.0f), 50.0f));
    scene::Material light = metallic(0.0f, 1.0f, 1.0f);
    light.emissive = glm::vec3(2.0f);
    // Its front looks down; from above, where the camera is, it is not there.
    add(scene, facing_square(static_cast<float>(half), 0.0f), light,
        glm::rotate(glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, height)), 3.14159265f,
                    glm::vec3(0, 1, 0)));
    Settings settings = small_settings(4, 0.002f, 4096);
    settings.model = view::Model::phong;
    settings.bounces = 1;
    const double edge = height / std::hypot(height, half * std::sqrt(2.0)); // the least cosine: the corners'
    // Schlick's grazing part of the highlight, which Ks = 0 leaves.
    const double highlight =
        ClosedPhong{0.0, 0.0, 50.0}.head_on([&](double cosine) { return cosine > edge ? 2.0 : 0.0; });
    for (Strategy strategy : {Strategy::both, Strategy::lights_only, Strategy::reflections_only}) {
        settings.strategy = strategy;
        const Result result = trace(scene, nullptr, settings);
        const Average m = average(result, whole(result), 0);
        EXPECT_NEAR(m.mean, 0.5 * 2.0 * factor, highlight + deviations * m.deviation)
            << static_cast<int>(strategy);
        EXPECT_LT(m.deviation, 0.005);
        EXPECT_LT(highlight, 0.002);
    }
}

} // namespace
} // namespace lambent::reference
