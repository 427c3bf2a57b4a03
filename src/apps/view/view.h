// A window that shows one session, and applies mouse and keys to it.
#pragma once

#include "apps/view/canvas.h"
#include "apps/view/input_handler.h"
#include "apps/view/window_settings.h"
#include "apps/view/panel.h"
#include "apps/view/screen.h"
#include "apps/view/window.h"
#include "apps/viewer/draw_scheduler.h"

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <string>

namespace lambent::view_window {

/// Used by the thread of the window; the scheduler's thread draws the pictures.
class View {
public:
    /// Opens the window. Throws Error(no_device) if that fails.
    View(viewer::ViewRequest start, const WindowSettings& settings, viewer::FileList files,
         viewer::AssetCache& assets);
    ~View();
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    /// Runs until the window is closed or `stopped` returns true, and all requested pictures are saved. Returns the
    /// settings to keep. If a picture cannot be saved, a closed window stays open and shows the reason; a stopped one
    /// throws Error(cannot_write).
    WindowSettings run(const std::function<bool()>& stopped);

    /// How long pictures that are being saved are waited for at the end.
    static constexpr std::chrono::seconds patience{60};

private:
    bool is_done(bool stopped);
    void draw();
    void act(const Pressed& pressed, const Asked& asked);
    void take_news();
    void take_picture(const viewer::ShownPicture& picture);
    void take_state(const std::string& words);
    void write(const viewer::Saved& saved);
    void give_up_saving(const std::string& why);
    void follow_size();
    void open_next();
    void notice(const std::string& line);
    void refuse(const std::string& line);

    Window window_;
    Canvas canvas_;
    viewer::DrawScheduler scheduler_;
    std::shared_ptr<Screen> screen_;
    std::shared_ptr<viewer::Session> session_;
    Panels panels_;
    Shown shown_;
    std::deque<Opening> openings_;
    std::deque<viewer::Clock::time_point>
        recent_; ///< when the pictures of the last second arrived while moving
    viewer::Clock::time_point noticed_{}, refused_{}, ending_{};
    int awaited_ = 0;     ///< requested pictures that are not saved yet
    std::string unsaved_; ///< why saving failed since the end was asked for; empty: it did not fail
};

} // namespace lambent::view_window
