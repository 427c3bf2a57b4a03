// Takes what the session shows, for the window's thread to fetch.
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

    /// What came since it was last asked for; of pictures the newest. `shown` counts those that came.
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
