// What stands over the picture: the panel of controls, the line below, and the help.
#pragma once

#include "apps/viewer/session.h"

#include <string>

namespace lambent::view_window {

/// What is shown at the moment.
struct Shown {
    viewer::Picture::Kind kind = viewer::Picture::Kind::moving;
    int width = 0, height = 0; ///< of the picture's own pixels
    double scale = 1.0, draw_ms = 0.0;
    bool loading = true;
    std::string error;   ///< of the session; empty: none
    std::string command; ///< that draws this picture
    std::string notice;  ///< what was saved or refused last
};

struct PanelState {
    bool panel = true, help = false;
};

/// What was pressed.
struct Pressed {
    bool save = false, copy = false, reset = false;
};

/// Refusals go into `shown.notice`.
Pressed show_panels(viewer::Session& session, Shown& shown, PanelState& state);

} // namespace lambent::view_window
