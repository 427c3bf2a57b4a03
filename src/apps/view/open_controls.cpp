#include "apps/view/open_controls.h"

#include "environment/builtin/builtin.h"
#include "scene/builtin/builtin.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>

namespace lambent::view_window {
namespace {

// The name without its folders, which do not fit into the panel.
std::string short_name(const std::string& name)
{
    return std::filesystem::path(name).filename().string();
}

void explain(const std::string& name)
{
    if (ImGui::IsItemHovered() && name != short_name(name))
        ImGui::SetTooltip("%s", name.c_str());
}

bool is_short_clear(const std::vector<std::string>& names, const std::string& name)
{
    return std::count_if(names.begin(), names.end(), [&](const std::string& other) {
               return short_name(other) == short_name(name);
           }) == 1;
}

// Indices are the labels for Dear ImGui, as names may contain "##", which it interprets.
std::string choose(const std::vector<std::string>& names, const std::string& now)
{
    std::string chosen;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string shown = is_short_clear(names, names[i]) ? short_name(names[i]) : names[i];
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable("##name", names[i] == now))
            chosen = names[i];
        explain(names[i]);
        ImGui::SameLine(0.0f, 0.0f);
        ImGui::TextUnformatted(shown.c_str());
        ImGui::PopID();
    }
    return chosen;
}

} // namespace

Opening opening_of(const std::string& name)
{
    if (scene::is_builtin(name))
        return {name, false}; // "furnace" is also an environment
    std::string extension = std::filesystem::path(name).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return {name,
            name == "none" || environment::is_builtin(name) || extension == ".hdr" || extension == ".exr"};
}

std::string as_typed(const std::string& words)
{
    const std::size_t first = words.find_first_not_of(" \t"), last = words.find_last_not_of(" \t");
    if (first == std::string::npos)
        return "";
    const std::string name = words.substr(first, last + 1 - first);
    const char* const home = std::getenv("HOME");
    return name.starts_with("~/") && home ? home + name.substr(1) : name;
}

std::optional<Opening> OpenControls::show(const viewer::ViewRequest& request)
{
    std::optional<Opening> opening;
    const auto combo = [&](const char* label, const std::string& now, bool is_environment) {
        if (!ImGui::BeginCombo(label, short_name(now).c_str(), ImGuiComboFlags_HeightLarge))
            return explain(now);
        if (ImGui::IsWindowAppearing())
            names_ = is_environment ? files_.environments() : files_.scenes();
        if (const std::string name = choose(names_, now); !name.empty())
            opening = {name, is_environment};
        ImGui::EndCombo();
    };
    combo("Model", request.asked.scene, false);
    combo("Environment", request.asked.environment, true);
    const bool entered = ImGui::InputTextWithHint("##path", "path of a file", typed_.data(), typed_.size(),
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::SameLine();
    if (ImGui::Button("Open") || entered)
        if (const std::string name = as_typed(typed_.data()); !name.empty())
            opening = opening_of(name);
    return opening;
}

} // namespace lambent::view_window
