// Files, lights and trouble in the window's panel.
#include "apps/view/open_controls.h"
#include "base/text.h"
#include "tests/scene/gltf_builder.h"
#include "tests/view_window/window_fixture.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace lambent::testing {
namespace {

void write_model(const std::string& path, bool warns)
{
    scene::test::GltfBuilder builder = scene::test::triangle();
    if (warns)
        builder.document["extensionsUsed"] = {"VENDOR_unheard_of"};
    const auto bytes = builder.glb();
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

TEST_F(ViewWindow, OpensWhatIsTypedAndTypingIsNoShortcut)
{
    open({"sphere"});
    write_model(path("resp+e.glb"), false);
    const Screenshot before = look();
    type_path("resp+e.glb");
    const Screenshot opened = look_changed(before, picture_area, 5.0);
    EXPECT_TRUE(is_titled("resp.e.glb")) << log();
    EXPECT_GT(opened.difference(before, picture_area), 5.0);
    EXPECT_FALSE(std::filesystem::exists(path("picture.png"))); // "s" saves elsewhere
    // What cannot be opened is said, and the old picture stays.
    type_path("/nowhere/rseps.glb");
    const Screenshot refused = look_said();
    EXPECT_LT(refused.difference(opened, picture_area), 0.5);
    EXPECT_LT(opened.redness(message_area), 0.001);
    EXPECT_GT(refused.redness(message_area), 0.005);
    EXPECT_TRUE(is_titled("resp.e.glb"));
    // The light around, by its ending; the button does what Return does.
    click(path_field);
    act({"key", "ctrl+a", "sleep", "0.2", "type", "--delay", "30", "studio"});
    click(open_button);
    EXPECT_GT(look_changed(opened, picture_area, 5.0).difference(opened, picture_area), 5.0);
    expect_end();
}

TEST_F(ViewWindow, ListsWhatIsInTheFolder)
{
    write_model(path("listed.glb"), false);
    open({"sphere"});
    const Screenshot closed = look();
    click(model_list);
    look_changed(closed, panel_area, 1.0);
    // Below it the built-in names, each a line of 19 pixels, then the files.
    click({model_list.x, model_list.y + 26 + 19 * 7});
    EXPECT_TRUE(is_titled("listed.glb")) << log();
    expect_end();
}

TEST_F(ViewWindow, WarningsOfTheSceneAreInThePanel)
{
    write_model(path("plain.glb"), false);
    write_model(path("warns.glb"), true);
    open({"plain.glb"});
    const Screenshot plain = look();
    type_path("warns.glb");
    const Screenshot warned = look_changed(plain, panel_area, 5.0);
    ASSERT_TRUE(is_titled("warns.glb")) << log();
    EXPECT_LT(warned.difference(plain, picture_area), 0.5);
    EXPECT_GT(warned.difference(plain, panel_area), 5.0); // everything is lower by the warning
    expect_end();
}

TEST_F(ViewWindow, LightsAreAddedMovedAndTakenAway)
{
    open({"sphere"});
    const Screenshot before = look();
    click(add_sun);
    const Screenshot sun = look_changed(before, picture_area, 0.2);
    EXPECT_GT(sun.mean(picture_area), before.mean(picture_area) + 0.2);
    // The row that the button was in is now the sun's, with "remove" in it.
    click({1010, add_sun.y});
    EXPECT_LT(look_like(before, picture_area, 0.2).difference(before, picture_area), 0.2);
    click(add_lamp);
    EXPECT_GT(look_changed(before, picture_area, 0.2).difference(before, picture_area), 0.2);
    expect_saved({"sphere", "--size", "1280x720", "--light", "point:1,2,1,2,2,2"});
}

TEST(ViewOpening, NamesSayWhatTheyAre)
{
    for (const char* name : {"studio", "none", "a.hdr", "/b/c.EXR"})
        EXPECT_TRUE(view_window::opening_of(name).is_environment) << name;
    for (const char* name : {"sphere", "furnace", "a.glb", "hdr", "", "a.hdr/"})
        EXPECT_FALSE(view_window::opening_of(name).is_environment) << name;
}

TEST(ViewOpening, TypedNamesLoseTheSpacesAround)
{
    EXPECT_EQ(view_window::as_typed("  a b.glb \t"), "a b.glb");
    EXPECT_EQ(view_window::as_typed("   "), "");
    EXPECT_EQ(view_window::as_typed("~x"), "~x");
    if (const char* home = std::getenv("HOME")) {
        EXPECT_EQ(view_window::as_typed("~/a.glb"), text(home, "/a.glb"));
    }
}

} // namespace
} // namespace lambent::testing
