// What the window remembers, and what it makes of a broken file.
#include "apps/view/memory.h"

#include <gtest/gtest.h>

namespace lambent::view_window {
namespace {

Memory read(const std::string& json, bool complains)
{
    std::string complaint;
    const Memory memory = read_memory(json, complaint);
    EXPECT_EQ(!complaint.empty(), complains) << json;
    return memory;
}

TEST(ViewMemory, ComesBackAsItWas)
{
    const Memory memory = read(write_memory({{1000, 640}, false}), false);
    EXPECT_EQ(memory.place.width, 1000);
    EXPECT_EQ(memory.place.height, 640);
    EXPECT_FALSE(memory.panel);
}

TEST(ViewMemory, WhatIsBrokenIsAsUsual)
{
    const Memory usual;
    for (const char* broken : {"", "{", "[]", "null", "{}", R"({"version":2,"width":999,"height":999})",
                               R"({"version":"1"})", "\xff\xfe"}) {
        const Memory memory = read(broken, true);
        EXPECT_EQ(memory.place.width, usual.place.width);
        EXPECT_TRUE(memory.panel);
    }
    for (const char* odd : {R"({"version":1})", R"({"version":1,"width":-4,"height":7})",
                            R"({"version":1,"width":1e99,"height":"x","panel":3})",
                            R"({"version":1,"width":99999999999999999999,"height":500})"}) {
        const Memory memory = read(odd, false);
        EXPECT_EQ(memory.place.width, usual.place.width) << odd;
        EXPECT_TRUE(memory.panel) << odd;
    }
}

} // namespace
} // namespace lambent::view_window
