// Queues the output of a session for the thread of the window.
#pragma once

#include "apps/viewer/shown_picture.h"

#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace lambent::view_window {

class Screen : public viewer::Presenter {
public:
    void show(viewer::ShownPicture picture) override;
    void say(const std::string& state) override;
    void save(viewer::Saved saved) override;

    /// The output since the last take(); of several pictures only the newest. `shown` counts all of them.
    struct News {
        std::optional<viewer::ShownPicture> picture;
        int shown = 0;
        std::optional<std::string> state;
        std::vector<viewer::Saved> saved;
    };
    News take();

private:
    std::mutex mutex_;
    News news_;
};

} // namespace lambent::view_window
