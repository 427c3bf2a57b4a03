// Models and panoramas that are dropped onto the window.
#include "tests/scene/gltf_builder.h"
#include "tests/view_window/dropping.h"
#include "tests/view_window/window_fixture.h"

#include "base/file.h"
#include "image/files/image_io.h"

namespace lambent::testing {
namespace {

// One colour from everywhere.
void write_panorama(const std::string& path, const std::vector<float>& color)
{
    image::RadianceImage panorama{8, 4, 3, {}};
    for (int i = 0; i < 8 * 4; ++i)
        panorama.values.insert(panorama.values.end(), color.begin(), color.end());
    image::write_radiance(panorama, path);
}

TEST_F(ViewWindow, OpensWhatIsDropped)
{
    write_file(path("dropped model.glb"), scene::test::triangle().glb());
    write_panorama(path("red.hdr"), {1.0f, 0.1f, 0.1f});
    write_panorama(path("blue.exr"), {0.1f, 0.1f, 1.0f});
    write_file(path("words.txt"), std::vector<std::uint8_t>{'h', 'i'});
    open({"sphere"});
    const Screenshot before = look();
    const auto dropped = [&](const std::string& title, const std::vector<std::string>& names) {
        std::vector<std::string> files;
        files.reserve(names.size());
        for (const std::string& name : names)
            files.push_back(path(name));
        const Screenshot last = look();
        EXPECT_EQ(drop(desktop_->display(), title + " - lambent", files), "");
        return look_changed(last, picture_area, 1.0);
    };
    const Screenshot red = dropped("sphere", {"red.hdr"});
    EXPECT_GT(red.redness(picture_area), before.redness(picture_area) + 0.5);
    const Screenshot both = dropped("sphere", {"dropped model.glb", "blue.exr"});
    EXPECT_TRUE(is_titled("dropped model.glb")) << log();
    EXPECT_LT(both.redness(picture_area), 0.1);
    // What is neither is said, and nothing else changes.
    EXPECT_EQ(drop(desktop_->display(), "dropped model.glb - lambent", {path("words.txt")}), "");
    const Screenshot refused = look_said();
    EXPECT_LT(refused.difference(both, picture_area), 0.5);
    EXPECT_GT(refused.redness(message_area), 0.005);
    EXPECT_TRUE(is_titled("dropped model.glb")) << log();
    expect_end();
}

} // namespace
} // namespace lambent::testing
