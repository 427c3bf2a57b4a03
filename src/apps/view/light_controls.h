// Controls for lights: suns (directional) and lamps (point lights).
#pragma once

#include "apps/viewer/light_words.h"
#include "apps/viewer/session.h"

#include <string>
#include <vector>

namespace lambent::view_window {

/// Keeps the fields that words of --light do not have: the colour of a light that is off, and the brightness of
/// colours.
class LightControls {
public:
    /// Shows a group of controls for each light and buttons to add more. Changes are applied to the session at once.
    /// Throws Error(usage).
    void show(viewer::Session& session, const std::vector<std::string>& words);

private:
    std::vector<std::string> words_;
    std::vector<viewer::LightFields> lights_;
};

} // namespace lambent::view_window
