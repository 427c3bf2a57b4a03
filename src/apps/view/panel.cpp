#include "apps/view/panel.h"

#include "apps/view/controls.h"
#include "apps/view/hands.h"
#include "base/error.h"
#include "scene/builtin.h"

#include <imgui.h>

namespace lambent::view_window {
namespace {

const char* name_of(viewer::Picture::Kind kind)
{
    using Kind = viewer::Picture::Kind;
    if (kind == Kind::rest)
        return "at rest";
    return kind == Kind::still ? "refining" : "moving";
}

Pressed show_controls_panel(viewer::Session& session, Shown& shown, PanelState& state)
{
    Pressed pressed;
    const ImGuiIO& io = ImGui::GetIO();
    const float width = 22.0f * ImGui::GetFontSize();
    ImGui::SetNextWindowPos({io.DisplaySize.x - width, 0.0f});
    ImGui::SetNextWindowSize({width, io.DisplaySize.y - 2.0f * ImGui::GetFrameHeightWithSpacing()});
    if (ImGui::Begin("lambent", &state.panel, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize)) {
        ImGui::PushItemWidth(9.5f * ImGui::GetFontSize());
        const viewer::Wish wish = session.wish();
        try {
            show_controls(session, wish.values, scene::is_builtin(wish.scene));
            show_lights(session, wish.lights);
        } catch (const Error& error) {
            shown.notice = error.what();
        }
        ImGui::Separator();
        pressed.save = ImGui::Button("Save (S)");
        ImGui::SameLine();
        pressed.copy = ImGui::Button("Copy command (C)");
        ImGui::SameLine();
        pressed.reset = ImGui::Button("Reset (R)");
        ImGui::PopItemWidth();
    }
    ImGui::End();
    return pressed;
}

void show_line(const Shown& shown)
{
    const ImGuiIO& io = ImGui::GetIO();
    const float height = 2.0f * ImGui::GetFrameHeightWithSpacing();
    ImGui::SetNextWindowPos({0.0f, io.DisplaySize.y - height});
    ImGui::SetNextWindowSize({io.DisplaySize.x, height});
    ImGui::SetNextWindowBgAlpha(0.75f);
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
    if (ImGui::Begin("##line", nullptr, flags)) {
        if (shown.loading)
            ImGui::TextUnformatted("loading");
        else
            ImGui::Text("%s  %dx%d  %.0f %%  %.0f ms   F1: keys", name_of(shown.kind), shown.width,
                        shown.height, 100.0 * shown.scale, shown.draw_ms);
        const std::string& said = !shown.error.empty() ? shown.error : shown.notice;
        if (!said.empty()) {
            ImGui::SameLine();
            ImGui::TextColored(shown.error.empty() ? ImVec4(0.7f, 0.9f, 1.0f, 1.0f)
                                                   : ImVec4(1.0f, 0.5f, 0.4f, 1.0f),
                               "%s", said.c_str());
        }
        ImGui::TextDisabled("%s", shown.command.c_str());
    }
    ImGui::End();
}

void show_help(PanelState& state)
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * size.x, 0.5f * size.y}, ImGuiCond_Always, {0.5f, 0.5f});
    if (ImGui::Begin("Keys and mouse", &state.help,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings))
        ImGui::TextUnformatted(hand_help);
    ImGui::End();
}

} // namespace

Pressed show_panels(viewer::Session& session, Shown& shown, PanelState& state)
{
    Pressed pressed;
    if (state.panel)
        pressed = show_controls_panel(session, shown, state);
    show_line(shown);
    if (state.help)
        show_help(state);
    return pressed;
}

} // namespace lambent::view_window
