// Wishes as command lines: what is shown can be typed.
#include "apps/viewer/wish.h"
#include "base/error.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

namespace lambent::viewer {
namespace {

TEST(Wish, WordsForTheShellAreQuotedWhereTheyMust)
{
    EXPECT_EQ(shell_quoted("a-b_c/d.e,f:1"), "a-b_c/d.e,f:1");
    EXPECT_EQ(shell_quoted(""), "''");
    EXPECT_EQ(shell_quoted("a b"), "'a b'");
    EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
    for (const std::string word :
         {"$(reboot)", "`x`", "a;b", "a\nb", "~", "*", "\\", "\"'\"", "#a", "!x", "\xc3\xa4"}) {
        // The shell itself is the judge.
        const testing::Outcome outcome =
            testing::run_program("/bin/sh", {"-c", "printf %s " + shell_quoted(word)});
        EXPECT_EQ(outcome.output, word);
    }
}

TEST(Wish, TheCommandSaysAllThatIsNotUsual)
{
    Wish wish{"my model.glb", "-sky.hdr", {}, Eye(10.0, -20.0), {}, 640, 360};
    wish.values.set("tone", "agx");
    set_lights(wish, {"point:1,2,3,4,5,6"});
    EXPECT_EQ(
        command_of(wish, "out.png"),
        "lambent render 'my model.glb' --env ./-sky.hdr --size 640x360 --camera 10,-20 --tone agx --light "
        "point:1,2,3,4,5,6 -o out.png");
    const cli::RenderArguments arguments = arguments_of(wish);
    EXPECT_EQ(arguments.scene, "my model.glb");
    EXPECT_EQ(arguments.environment, "./-sky.hdr");
    EXPECT_EQ(arguments.settings.lights.size(), 1u);
    EXPECT_EQ(arguments.display.tone, display::Tone::agx);
}

TEST(Wish, AMomentIsOfTheSceneThatItWasGivenWith)
{
    cli::StartArguments start;
    start.picture.scene = "walker.glb";
    start.words = {{"animation", "-walk"}, {"moment", "0.5"}};
    Wish wish = first_wish(start);
    const cli::RenderArguments arguments = arguments_of(wish);
    EXPECT_EQ(arguments.animation, "-walk");
    EXPECT_EQ(arguments.moment, 0.5);
    wish.scene = "sphere";
    EXPECT_FALSE(arguments_of(wish).moment.has_value());
}

TEST(Wish, LightsAreCheckedAndCounted)
{
    Wish wish{"grid", "kitchen", {}, {}, {}};
    EXPECT_THROW(set_lights(wish, {"spot:1"}), Error);
    EXPECT_THROW(set_lights(wish, {"point:1,2,3,-4,5,6"}), Error);
    EXPECT_THROW(set_lights(wish, std::vector<std::string>(most_lights + 1, "point:1,2,3,4,5,6")), Error);
    EXPECT_TRUE(wish.lights.empty());
}

TEST(Wish, SizesAreCutInProportion)
{
    Wish wish{"grid", "kitchen", {}, {}, {}};
    set_size(wish, 1280.0, 720.0);
    EXPECT_EQ(wish.width, 1280);
    EXPECT_EQ(wish.height, 720);
    set_size(wish, 1.0e300, 1.0e300);
    EXPECT_LE(wish.width * wish.height, most_pixels);
    EXPECT_EQ(wish.width, wish.height);
    set_size(wish, 16384.0, 16.0);
    EXPECT_LE(wish.width * wish.height, most_pixels);
    set_size(wish, std::nan(""), -5.0);
    EXPECT_EQ(wish.width, 16);
    EXPECT_EQ(wish.height, 16);
}

} // namespace
} // namespace lambent::viewer
