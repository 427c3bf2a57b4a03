// The windows over the picture: the panel of controls, the status line, messages and the help.
#pragma once

#include "apps/view/light_controls.h"
#include "apps/view/open_controls.h"
#include "apps/viewer/session.h"

#include <optional>
#include <string>
#include <vector>

namespace lambent::view_window {

/// What the status line and the messages show.
struct Shown {
    viewer::ShownPicture::Kind kind = viewer::ShownPicture::Kind::moving;
    int width = 0, height = 0; ///< of the picture as drawn, in pixels
    double scale = 1.0, draw_ms = 0.0;
    double rate = 0.0;                                  ///< pictures per second of a moving view; 0: unknown
    std::optional<viewer::ShownPicture::Traced> traced; ///< set while the reference or its error is shown
    bool is_last = false;                               ///< no better picture follows
    bool lacks_shadows = false;                         ///< as of viewer::ShownPicture
    std::optional<audit::Error> measured;               ///< the picture's error, as there
    bool loading = true;
    bool saving = false, ending = false; ///< ending: the window closes once pictures are saved
    std::vector<std::string> warnings;   ///< of the scene
    std::string error;                   ///< of the session; empty: none
    std::string refusal;                 ///< why the last input was refused; empty: it was not
    std::string notice;                  ///< confirms the last action for a while; empty: none
    std::string command;                 ///< draws this picture
};

/// The buttons that were pressed in this frame.
struct Pressed {
    bool save = false, copy = false, reset = false, help = false;
    std::optional<Opening> opening;
    std::string refusal; ///< why a changed control was refused; empty: none was
};

class Panels {
public:
    Panels(viewer::FileList files, bool open) : is_open(open), files_(std::move(files)) {}

    /// Shows all; changes of controls are applied to the session at once.
    Pressed show(viewer::Session& session, const Shown& shown);

    /// Closes the help; if it is closed, takes the keyboard focus from the panel.
    void leave();

    bool is_open = true, help = false;

private:
    void release_keys();
    Pressed show_panel(viewer::Session& session, const Shown& shown);

    OpenControls files_;
    LightControls lights_;
    bool was_open_ = false, had_help_ = false;
    int release_ = 0; ///< frames for which the keyboard focus is still taken from all windows
};

} // namespace lambent::view_window
