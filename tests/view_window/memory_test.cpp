// What the window remembers, and what it makes of a broken file.
#include "apps/view/window_settings.h"

#include <gtest/gtest.h>

namespace lambent::view_window {
namespace {

WindowSettings read(const std::string& json, bool complains)
{
    std::string complaint;
    const WindowSettings memory = read_settings(json, complaint);
    EXPECT_EQ(!complaint.empty(), complains) << json;
    return memory;
}

TEST(ViewMemory, ComesBackAsItWas)
{
    const WindowSettings memory = read(write_settings({{1000, 640, {{-20, 30}}, true}, false}), false);
    EXPECT_EQ(memory.place.width, 1000);
    EXPECT_EQ(memory.place.height, 640);
    ASSERT_TRUE(memory.place.corner);
    EXPECT_EQ(memory.place.corner->x, -20);
    EXPECT_EQ(memory.place.corner->y, 30);
    EXPECT_TRUE(memory.place.maximised);
    EXPECT_FALSE(memory.panel);
    EXPECT_FALSE(read(write_settings({}), false).place.corner);
}

TEST(ViewMemory, WhatIsBrokenIsAsUsual)
{
    const WindowSettings usual;
    for (const char* broken : {"", "{", "[]", "null", "{}", R"({"version":2,"width":999,"height":999})",
                               R"({"version":"1"})", "\xff\xfe"}) {
        const WindowSettings memory = read(broken, true);
        EXPECT_EQ(memory.place.width, usual.place.width);
        EXPECT_TRUE(memory.panel);
    }
    for (const char* odd :
         {R"({"version":1})", R"({"version":1,"width":-4,"height":7})",
          R"({"version":1,"width":1e99,"height":"x","panel":3})",
          R"({"version":1,"width":99999999999999999999,"height":500})",
          R"({"version":1,"x":10,"y":99999999,"maximised":"yes"})", R"({"version":1,"x":10})"}) {
        const WindowSettings memory = read(odd, false);
        EXPECT_EQ(memory.place.width, usual.place.width) << odd;
        EXPECT_FALSE(memory.place.corner) << odd;
        EXPECT_FALSE(memory.place.maximised) << odd;
        EXPECT_TRUE(memory.panel) << odd;
    }
}

WindowPlace at(int x, int y)
{
    return {800, 600, {{x, y}}, false};
}

TEST(WindowPlace, IsOnlyUsedWhereItCanBeTakenHoldOf)
{
    const std::vector<WorkArea> two = {{0, 30, 1920, 1050}, {1920, 0, 1280, 1024}};
    for (const WindowPlace& seen : {at(0, 30), at(500, 300), at(-600, 100), at(1800, 50), at(3000, 900)})
        EXPECT_TRUE(reachable(seen, two).corner) << seen.corner->x << "," << seen.corner->y;
    for (const WindowPlace& lost : {at(-750, 100), at(3150, 100), at(100, -500), at(100, 1060),
                                    at(5000, 5000), at(-2147483647, 0), at(2147483647, 2147483647)})
        EXPECT_FALSE(reachable(lost, two).corner) << lost.corner->x << "," << lost.corner->y;
    EXPECT_TRUE(reachable(at(5000, 5000), {}).corner); // nobody says where windows may be
}

TEST(WindowPlace, IsNoLargerThanTheScreen)
{
    const WindowPlace place = reachable({4000, 500, {}, true}, {{0, 0, 1280, 800}});
    EXPECT_EQ(place.width, 1280);
    EXPECT_EQ(place.height, 500);
    EXPECT_TRUE(place.maximised);
}

} // namespace
} // namespace lambent::view_window
