#include "apps/view/light_controls.h"

#include "base/text.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lambent::view_window {
namespace {

using viewer::LightFields;

bool angle(const char* label, double& degrees, double most)
{
    return ImGui::SliderScalar(label, ImGuiDataType_Double, &degrees, std::array{-most}.data(),
                               std::array{most}.data(), "%.1f", ImGuiSliderFlags_AlwaysClamp);
}

// The speed of dragging grows with the distance from the origin, as the size of the scene is unknown here.
bool place(std::array<double, 3>& metres)
{
    const double far_out = std::max({std::abs(metres[0]), std::abs(metres[1]), std::abs(metres[2]), 0.1});
    return ImGui::DragScalarN("x y z, m", ImGuiDataType_Double, metres.data(), 3,
                              static_cast<float>(0.01 * far_out), nullptr, nullptr, "%.3g");
}

bool strength(const char* label, double& value)
{
    constexpr double least = 0.01, most = 1e5; // more can be typed
    return ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &least, &most, "%.4g",
                               ImGuiSliderFlags_Logarithmic);
}

bool color(std::array<double, 3>& screen)
{
    std::array<float, 3> shown{};
    std::transform(screen.begin(), screen.end(), shown.begin(),
                   [](double part) { return static_cast<float>(part); });
    if (!ImGui::ColorEdit3("Colour", shown.data()))
        return false;
    std::copy(shown.begin(), shown.end(), screen.begin());
    return true;
}

bool change(LightFields& light)
{
    bool changed = false;
    if (light.is_sun) {
        changed |= angle("Azimuth", light.place[0], 180.0);
        changed |= angle("Elevation", light.place[1], 90.0);
    } else {
        changed |= place(light.place);
    }
    changed |= strength(light.is_sun ? "Strength, lx" : "Strength, cd", light.strength);
    changed |= color(light.color);
    return changed;
}

} // namespace

void LightControls::show(viewer::Session& session, const std::vector<std::string>& words)
{
    if (!ImGui::CollapsingHeader("Lights", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    if (words != words_) {
        lights_.clear();
        for (const std::string& word : words)
            lights_.push_back(viewer::read_light(word));
        words_ = words;
    }
    bool changed = false;
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        ImGui::Text("%s %d", lights_[i].is_sun ? "Sun" : "Lamp", static_cast<int>(i) + 1);
        ImGui::SameLine();
        if (ImGui::SmallButton("remove"))
            removed = i;
        changed |= change(lights_[i]);
        ImGui::PopID();
    }
    if (removed)
        lights_.erase(lights_.begin() + static_cast<std::ptrdiff_t>(*removed));
    const auto add = [&](const char* button, const char* word) {
        if (!ImGui::SmallButton(button) || lights_.size() >= viewer::most_lights)
            return false;
        lights_.push_back(viewer::read_light(word));
        return true;
    };
    bool added = add("add a sun", "directional:45,45,2,2,2");
    ImGui::SameLine();
    added |= add("add a lamp", "point:1,2,1,2,2,2");
    if (!changed && !removed && !added)
        return;
    words_.clear();
    std::transform(lights_.begin(), lights_.end(), std::back_inserter(words_), viewer::light_word);
    session.change(0, [&](viewer::ViewRequest& request, const viewer::OrbitCamera::World&) {
        viewer::set_lights(request, words_);
    });
}

} // namespace lambent::view_window
