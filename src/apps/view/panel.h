// What stands over the picture: the panel of controls, the line below, what there is to say, and the help.
#pragma once

#include "apps/view/light_controls.h"
#include "apps/view/open_controls.h"
#include "apps/viewer/session.h"

#include <optional>
#include <string>
#include <vector>

namespace lambent::view_window {

/// What is shown at the moment.
struct Shown {
    viewer::ShownPicture::Kind kind = viewer::ShownPicture::Kind::moving;
    int width = 0, height = 0; ///< of the picture's own pixels
    double scale = 1.0, draw_ms = 0.0;
    double rate = 0.0; ///< pictures a second while something moves; 0: not known
    std::optional<viewer::ShownPicture::Traced> traced; ///< of the reference, if that is shown
    bool is_last = false;                               ///< nothing better follows
    bool loading = true;
    bool saving = false, ending = false; ///< ending: the window closes when what is saved is
    std::vector<std::string> warnings;   ///< of the scene
    std::string error;                   ///< of the session; empty: none
    std::string refusal;                 ///< why the last request was not taken; empty: it was
    std::string notice;                  ///< what was done last; empty: nothing, or long ago
    std::string command;                 ///< that draws this picture
};

/// What was pressed.
struct Pressed {
    bool save = false, copy = false, reset = false, help = false;
    std::optional<Opening> opening;
    std::string refusal; ///< why what was moved was not taken; empty: it was
};

class Panels {
public:
    Panels(viewer::FileList files, bool open) : is_open(open), files_(std::move(files)) {}

    /// What is moved is set at once.
    Pressed show(viewer::Session& session, const Shown& shown);

    /// Out of the help, or of the panel's keys.
    void leave();

    bool is_open = true, help = false;

private:
    void release_keys();
    Pressed show_panel(viewer::Session& session, const Shown& shown);

    OpenControls files_;
    LightControls lights_;
    bool was_open_ = false, had_help_ = false;
    int release_ = 0; ///< in so many frames the keys go back to the picture
};

} // namespace lambent::view_window
