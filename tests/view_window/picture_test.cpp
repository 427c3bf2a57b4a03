// How the window looks: the picture in docs/VIEWER.md, and letters on dense screens.
#include "apps/view/window.h"
#include "base/file.h"
#include "base/text.h"
#include "image/files/image_io.h"
#include "image/codes/png.h"
#include "tests/view_window/window_fixture.h"

#include <imgui.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include <cstdlib>
#include <filesystem>

namespace lambent::testing {
namespace {

// All of the window, as large as it is opened.
image::CodeImage cut(const Screenshot& shot, int width, int height)
{
    image::CodeImage picture{width, height, 3, 8, {}};
    for (int y = 0; y < height; ++y) {
        const auto row = shot.rgb.begin() + static_cast<std::ptrdiff_t>(3) * y * shot.width;
        picture.bytes.insert(picture.bytes.end(), row, row + static_cast<std::ptrdiff_t>(3) * width);
    }
    return picture;
}

Screenshot shot_of(const image::CodeImage& picture)
{
    Screenshot shot{picture.width, picture.height, {}};
    for (std::size_t i = 0; i < picture.bytes.size(); ++i)
        if (picture.channels == 3 || i % 4 != 3)
            shot.rgb.push_back(picture.bytes[i]);
    return shot;
}

void write(const image::CodeImage& picture, const std::filesystem::path& path)
{
    write_file(path, image::encode_png(picture, {9, 0, 8 | 16 | 32 | 64 | 128}));
}

TEST_F(ViewWindow, LooksAsInTheDocumentation)
{
    open({"teapot", "--env-rotation", "50", "--light", "directional:-60,35,2,1.6,1.2", "--size", "1280x720",
          "--bounces", "8"});
    look();
    // From under the panel, by the right button.
    act({"mousemove", "450", "300",       "sleep", "0.1", "mousedown", "3",
         "sleep",     "0.1", "mousemove", "360",   "280", "sleep",     "0.1",
         "mousemove", "270", "260",       "sleep", "0.1", "mouseup",   "3"});
    act({"mousemove", "1279", "799"});
    const std::filesystem::path committed = std::filesystem::path(LAMBENT_ROOT) / "docs/viewer/window.png";
    const bool updates = std::getenv("LAMBENT_UPDATE_PICTURES") != nullptr;
    const Screenshot wanted = shot_of(image::read_codes(committed));
    const image::CodeImage seen = cut(updates ? look() : look_like(wanted, picture_area, 1.0), 1280, 720);
    expect_end();
    if (updates)
        write(seen, committed);
    const Screenshot now = shot_of(seen), then = shot_of(image::read_codes(committed));
    ASSERT_EQ(then.width, now.width);
    ASSERT_EQ(then.height, now.height);
    // Drivers may draw letters a little otherwise; another layout is off by far more.
    const double picture = now.difference(then, picture_area), panel = now.difference(then, panel_area);
    EXPECT_LT(picture, 1.0);
    EXPECT_LT(panel, 6.0);
    if (HasFailure()) {
        write(seen, "window.png");
        ADD_FAILURE() << std::filesystem::absolute("window.png") << " is not " << committed
                      << "; LAMBENT_UPDATE_PICTURES=1 makes that anew";
    }
}

TEST_F(ViewWindow, LettersFollowTheContentScale)
{
#ifdef __SANITIZE_ADDRESS__
    const __lsan::ScopedDisabler
        drivers_keep_memory; // to the end of the program, in libraries closed by then
#endif
    ::setenv("DISPLAY", desktop_->display().c_str(), 1);
    view_window::Window window("letters", {});
    const auto size_at = [&](float scale) {
        window.set_scale(scale);
        window.begin();
        const float size = ImGui::GetFontSize();
        ImGui::Begin("text");
        ImGui::TextUnformatted("text");
        ImGui::End();
        window.end();
        return size;
    };
    EXPECT_EQ(size_at(1.0f), 15.0f);
    EXPECT_EQ(size_at(2.0f), 30.0f);
    EXPECT_EQ(ImGui::GetStyle().WindowPadding.x, 16.0f);
    EXPECT_EQ(size_at(1.0f), 15.0f); // and back: sizes are not scaled twice
    EXPECT_EQ(ImGui::GetStyle().WindowPadding.x, 8.0f);
    for (const float odd : {0.0f, -1.0f, 1e30f})
        EXPECT_GE(size_at(odd), 7.0f);
}

} // namespace
} // namespace lambent::testing
