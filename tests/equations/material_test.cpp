// From texels and factors to a material at a point: each parameter by hand.
#include "tests/equations/directions.h"

#include <gtest/gtest.h>

namespace lambent::in_double {
namespace {
#include "shading/choices.glsl"
#include "shading/material/material.glsl"
} // namespace
} // namespace lambent::in_double

namespace lambent::test {
namespace {

using namespace in_double;

constexpr Texel white = {1.0, 1.0, 1.0, 1.0};

Texels white_texels()
{
    return {
#define TEXTURE(name, number, transfer, object, key) white,
#define NORMAL_TEXTURE(name, number, object, key) white,
#include "shading/material/textures.h"
    };
}

Material default_factors()
{
    return {
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) vec3(value), value,
#define COLOR(name, number, value, object, key, texture) vec3(value),
#define SCALAR(name, number, value, object, key, texture, channel) value,
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) value,
#define STRENGTH(name, factor, number, value, object, key, texture, channel) value,
#include "shading/material/parameters.h"
    };
}

TEST(Material, IsAWhiteRoughMetalByDefault)
{
    const Material m = material_of(default_factors(), white_texels(), white, alpha_opaque);
    EXPECT_EQ(m.base_color.x, 1.0);
    EXPECT_EQ(m.metallic, 1.0);
    EXPECT_EQ(m.alpha, 1.0);
    EXPECT_EQ(m.occlusion, 1.0);
    EXPECT_EQ(m.opacity, 1.0);
    EXPECT_EQ(m.emissive.y, 0.0);
}

// G is the roughness and B the metalness of one texture, R of another the occlusion. [glTF 2.0, 3.9.2 and 3.9.3]
TEST(Material, TakesEachParameterFromItsOwnChannel)
{
    Texels t = white_texels();
    t.metallic_roughness = {0.9, 0.5, 0.25, 0.1};
    t.occlusion = {0.6, 0.1, 0.2, 0.3};
    t.emissive = {0.1, 0.2, 0.3, 0.4};
    t.base_color = {0.5, 0.25, 0.125, 0.75};
    Material f = default_factors();
    f.metallic = 0.5, f.alpha = 0.8, f.occlusion = 0.5, f.emissive = vec3(10.0, 20.0, 30.0);
    f.base_color = vec3(0.5, 1.0, 1.0), f.opacity = 0.5;
    const Material m = material_of(f, t, {1.0, 0.5, 1.0, 0.5}, alpha_blend);
    EXPECT_NEAR(m.metallic, 0.25 * 0.5, 1e-15);
    EXPECT_NEAR(m.alpha, 0.4 * 0.4, 1e-15);
    EXPECT_NEAR(m.occlusion, 1.0 + 0.5 * (0.6 - 1.0), 1e-15);
    EXPECT_NEAR(m.emissive.z, 9.0, 1e-15);
    EXPECT_NEAR(m.base_color.x, 0.25, 1e-15);
    EXPECT_NEAR(m.base_color.y, 0.125, 1e-15) << "vertex colours multiply";
    EXPECT_NEAR(m.opacity, 0.75 * 0.5 * 0.5, 1e-15);
}

TEST(Material, StaysInItsRange)
{
    Material f = default_factors();
    f.metallic = 3.0, f.alpha = 7.0;
    const Material m = material_of(f, white_texels(), white, alpha_opaque);
    EXPECT_EQ(m.metallic, 1.0);
    EXPECT_EQ(m.alpha, 1.0);
    EXPECT_EQ(alpha_of_roughness(0.5), 0.25);
    EXPECT_EQ(alpha_of_roughness(0.0), 1e-4);
}

TEST(Material, TakesAlphaByItsMode)
{
    EXPECT_EQ(opacity_of(alpha_opaque, 0.3, 0.2), 1.0);
    EXPECT_EQ(opacity_of(alpha_mask, 0.3, 0.2), 0.3) << "the share that is there";
    EXPECT_EQ(opacity_of(alpha_blend, 0.3, 0.2), 0.2);
}

} // namespace
} // namespace lambent::test
