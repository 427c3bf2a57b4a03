// Words of --light as fields and back, and that no fields make a word that is refused.
#include "apps/options/values.h"
#include "apps/viewer/light_words.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace lambent::viewer {
namespace {

scene::Light parsed(const std::string& word)
{
    return cli::parse_light(word, "light");
}

TEST(LightWords, FieldsAreWhatPeopleSay)
{
    const LightFields sun = read_light("directional:30,45,3,3,3");
    EXPECT_TRUE(sun.is_sun);
    EXPECT_EQ(sun.place[0], 30.0);
    EXPECT_EQ(sun.place[1], 45.0);
    EXPECT_EQ(sun.strength, 3.0);
    for (const double part : sun.color)
        EXPECT_NEAR(part, 1.0, 1e-6);
    const LightFields lamp = read_light("point:1,-2,3,8,4,0");
    EXPECT_FALSE(lamp.is_sun);
    EXPECT_EQ(lamp.place, (std::array<double, 3>{1.0, -2.0, 3.0}));
    EXPECT_EQ(lamp.strength, 8.0);
    EXPECT_NEAR(lamp.color[0], 1.0, 1e-6);
    EXPECT_NEAR(lamp.color[1] * 255.0, 188.0, 0.5); // half the light
    EXPECT_EQ(lamp.color[2], 0.0);
}

TEST(LightWords, WordsComeBack)
{
    for (const char* word : {"directional:30,45,3,3,3", "directional:-179,-90,0.001,0.002,0.0005",
                             "directional:200,120,1,2,3", "directional:720,-100,1e5,2e4,0",
                             "point:1,2,3,4,5,6", "point:0,0,0,0,0,0", "point:-1e5,1e-5,0.1,0,0,7"}) {
        const scene::Light before = parsed(word), after = parsed(light_word(read_light(word)));
        EXPECT_LT(glm::distance(before.intensity, after.intensity),
                  1e-4f * glm::length(before.intensity) + 1e-9f)
            << word;
        EXPECT_LT(glm::distance(before.position, after.position),
                  1e-4f * glm::length(before.position) + 1e-9f)
            << word;
        if (before.kind == scene::LightKind::directional) {
            EXPECT_LT(glm::distance(before.direction, after.direction), 1e-4f) << word;
        }
    }
    EXPECT_EQ(light_word(read_light("directional:30,45,3,3,3")), "directional:30,45,3,3,3");
}

TEST(LightWords, TheColoursBrightnessIsNotTheStrengthButBlackIsOff)
{
    LightFields light;
    light.strength = 10.0;
    light.color = {0.2, 0.2, 0.2};
    EXPECT_EQ(light_word(light), "point:0,0,0,10,10,10");
    light.color = {};
    EXPECT_EQ(light_word(light), "point:0,0,0,0,0,0");
}

TEST(LightWords, WhateverTheFieldsTheWordIsUnderstood)
{
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    for (const bool is_sun : {true, false})
        for (const double value : {nan, infinity, -infinity, 1e300, -1e300, -1.0, 0.0, 1e-300}) {
            const LightFields light{is_sun, {value, value, value}, value, {value, 0.5, value}};
            EXPECT_NO_THROW(parsed(light_word(light))) << value;
            const LightFields black{is_sun, {value, value, value}, value, {value, value, value}};
            EXPECT_NO_THROW(read_light(light_word(black))) << value;
        }
}

TEST(LightWords, WordsThatAreNoLightsAreRefused)
{
    for (const char* word : {"", "sun", "directional:1,2,3", "point:1,2,3,4,5,-6", "point:1,2,3,4,5,nan"})
        EXPECT_THROW(read_light(word), Error) << word;
}

TEST(LightWords, ColoursGoToTheScreenAndBack)
{
    // [IEC 61966-2-1] Published: code 188 is 0.5029 of the light.
    EXPECT_NEAR(linear_color({188.0 / 255.0, 0.0, 1.0})[0], 0.5029, 1e-4);
    const std::array<double, 3> there = screen_color(linear_color({0.1, 0.5, 0.9}));
    EXPECT_NEAR(there[0], 0.1, 1e-6);
    EXPECT_NEAR(there[1], 0.5, 1e-6);
    EXPECT_NEAR(there[2], 0.9, 1e-6);
}

} // namespace
} // namespace lambent::viewer
