// Where a window stands, and whether it can be seen there.
#pragma once

#include <optional>
#include <vector>

namespace lambent::view_window {

/// In the units of the screen.
struct WindowPlace {
    int width = 1280, height = 720;
    struct Corner {
        int x = 0, y = 0;
    };
    std::optional<Corner> corner; ///< top left of the picture; none: wherever the desktop puts it
    bool maximised = false;
};

/// A part of the desktop where windows may be: one of each monitor.
struct WorkArea {
    int x = 0, y = 0, width = 0, height = 0;
};

/// The same place without a corner if too little of the window's top would be seen to take hold of it, and no larger than
/// the largest area, if there is any.
WindowPlace reachable(WindowPlace place, const std::vector<WorkArea>& areas);

} // namespace lambent::view_window
