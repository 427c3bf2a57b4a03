// Controls for suns and lamps.
#pragma once

#include "apps/viewer/light_words.h"
#include "apps/viewer/session.h"

#include <string>
#include <vector>

namespace lambent::view_window {

/// Keeps what controls show while words say less: the colour of a light that is off, and its brightness.
class LightControls {
public:
    /// A group for each light and buttons for more. What is moved is set at once. Throws Error(usage).
    void show(viewer::Session& session, const std::vector<std::string>& words);

private:
    std::vector<std::string> words_;
    std::vector<viewer::LightFields> lights_;
};

} // namespace lambent::view_window
