// The position and size of a window, and whether it can be reached there.
#pragma once

#include <optional>
#include <vector>

namespace lambent::view_window {

/// In screen units.
struct WindowPlace {
    int width = 1280, height = 720;
    struct Corner {
        int x = 0, y = 0;
    };
    std::optional<Corner> corner; ///< top left of the content; unset: the desktop chooses
    bool maximised = false;
};

/// The part of a monitor that windows may cover.
struct WorkArea {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Returns the place limited to the size of the largest area, and without a corner where too little of the window's top
/// edge would be visible to drag it. Without areas it is returned unchanged.
WindowPlace reachable(WindowPlace place, const std::vector<WorkArea>& areas);

} // namespace lambent::view_window
