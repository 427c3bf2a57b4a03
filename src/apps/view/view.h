// A window onto one session: what comes from hands goes to the session, and what that shows onto the screen.
#pragma once

#include "apps/view/canvas.h"
#include "apps/view/input_handler.h"
#include "apps/view/memory.h"
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

/// The window's thread; pictures are drawn by the scheduler's.
class View {
public:
    /// Throws Error(no_device) where no window can be opened.
    View(viewer::ViewRequest start, const Memory& memory, viewer::FileList files, viewer::AssetCache& assets);
    ~View();
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    /// Until the window is closed or `stopped` says so, and what was asked to be saved is. What is to be remembered then.
    /// Throws Error(cannot_write) if it was stopped and that cannot be saved; closed it stays and shows the reason.
    Memory run(const std::function<bool()>& stopped);

    /// How long what is being saved is waited for.
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
    std::deque<viewer::Clock::time_point> recent_; ///< pictures while moving
    viewer::Clock::time_point noticed_{}, refused_{}, ending_{};
    int awaited_ = 0;     ///< pictures that were asked to be saved
    std::string unsaved_; ///< why one could not be since the end was asked for; empty: all could
};

} // namespace lambent::view_window
