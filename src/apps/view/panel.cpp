#include "apps/view/panel.h"

#include "apps/common/picture_audit.h"
#include "apps/view/animation_controls.h"
#include "apps/view/controls.h"
#include "apps/view/input_handler.h"
#include "base/error.h"
#include "base/text.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <utility>

namespace lambent::view_window {
namespace {

// No window takes the keyboard focus until it is clicked.
constexpr ImGuiWindowFlags quiet = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoFocusOnAppearing;
constexpr ImGuiWindowFlags bare = quiet | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoScrollbar;
const ImVec4 red = {1.0f, 0.5f, 0.4f, 1.0f}, yellow = {1.0f, 0.85f, 0.4f, 1.0f},
             blue = {0.7f, 0.9f, 1.0f, 1.0f};

float line_height()
{
    return 2.0f * ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().WindowPadding.y;
}

float panel_width()
{
    return std::min(24.0f * ImGui::GetFontSize(), 0.6f * ImGui::GetIO().DisplaySize.x);
}

void wrapped(const std::string& line, const ImVec4& color)
{
    if (line.empty())
        return;
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(line.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

std::string percent(double part)
{
    return text(std::setprecision(2), 100.0 * part, " %");
}

std::string traced_status(const std::string& size, const Shown& shown)
{
    const viewer::ShownPicture::Traced& traced = *shown.traced;
    std::string line = text(size, ", traced: ", std::lround(traced.samples), " samples");
    if (traced.noise)
        line += text(", noise ", percent(*traced.noise));
    line += text("; drawn picture's error ", percent(traced.error));
    if (traced.flip)
        line += text(", FLIP ", std::setprecision(3), *traced.flip);
    return shown.is_last ? line : text(line, ", refining");
}

std::string status(const Shown& shown)
{
    if (shown.loading)
        return "loading";
    const std::string size = text(shown.width, "x", shown.height);
    if (shown.traced)
        return traced_status(size, shown);
    const std::string ms = text(std::lround(shown.draw_ms), " ms");
    if (shown.kind != viewer::ShownPicture::Kind::moving)
        return text(size, ", ", ms,
                    shown.measured ? text(", ", cli::in_words(*shown.measured)) : std::string(),
                    shown.is_last ? "" : ", refining");
    const std::string rate = shown.rate > 0.0 ? text(std::lround(shown.rate), "/s, ") : "";
    return text(rate, size, " at ", std::lround(100.0 * shown.scale), " %, ", ms,
                shown.lacks_shadows ? ", without shadows" : "");
}

Pressed show_buttons()
{
    Pressed pressed;
    pressed.save = ImGui::Button("Save (S)");
    ImGui::SameLine();
    pressed.reset = ImGui::Button("Reset (R)");
    ImGui::SameLine();
    pressed.help = ImGui::Button("Keys (F1)");
    return pressed;
}

void show_line(const Shown& shown, Pressed& pressed)
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.0f, size.y - line_height()});
    ImGui::SetNextWindowSize({size.x, line_height()});
    ImGui::SetNextWindowBgAlpha(0.85f);
    if (ImGui::Begin("##line", nullptr, bare)) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(status(shown).c_str());
        if (shown.saving)
            ImGui::SameLine(), ImGui::TextColored(blue, "saving");
        pressed.copy |= ImGui::Button("Copy (C)");
        ImGui::SameLine();
        // A text field, so that the command can be scrolled and selected.
        std::string command = shown.command;
        ImGui::SetNextItemWidth(-1.0f);
        ImGui::InputText("##command", command.data(), command.size() + 1, ImGuiInputTextFlags_ReadOnly);
    }
    ImGui::End();
}

void show_messages(const Shown& shown, float width)
{
    const std::string ending =
        shown.ending ? "The picture is being saved; this window closes afterwards." : "";
    if (shown.error.empty() && shown.refusal.empty() && shown.notice.empty() && ending.empty())
        return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.0f, size.y - line_height()}, ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowSize({width, 0.0f});
    ImGui::SetNextWindowBgAlpha(0.85f);
    if (ImGui::Begin("##messages", nullptr, bare | ImGuiWindowFlags_NoInputs)) {
        wrapped(shown.error, red);
        if (shown.refusal != shown.error)
            wrapped(shown.refusal, red);
        wrapped(shown.notice, blue);
        wrapped(ending, yellow);
    }
    ImGui::End();
}

void show_help(bool& open)
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * size.x, 0.5f * size.y}, ImGuiCond_Always, {0.5f, 0.5f});
    if (ImGui::Begin("Keys and mouse", &open, quiet | ImGuiWindowFlags_AlwaysAutoResize)) {
        for (const Shortcut& shortcut : shortcuts()) {
            ImGui::TextUnformatted(shortcut.keys.data(), shortcut.keys.data() + shortcut.keys.size());
            ImGui::SameLine(8.0f * ImGui::GetFontSize());
            ImGui::TextUnformatted(shortcut.meaning.data(),
                                   shortcut.meaning.data() + shortcut.meaning.size());
        }
        ImGui::Separator();
        ImGui::TextUnformatted("Drop a model (.gltf, .glb) or a panorama (.hdr, .exr)\nhere to open it.\n"
                               "Right-click a control to set its default.\n"
                               "Ctrl-click a slider to type a number.");
    }
    ImGui::End();
}

} // namespace

Pressed Panels::show_panel(viewer::Session& session, const Shown& shown)
{
    Pressed pressed;
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({io.DisplaySize.x - panel_width(), 0.0f});
    ImGui::SetNextWindowSize({panel_width(), io.DisplaySize.y - line_height()});
    if (ImGui::Begin("lambent", &is_open, quiet)) {
        ImGui::PushItemWidth(0.5f * panel_width());
        const viewer::ViewRequest request = session.request();
        try {
            const std::optional<Opening> opening = files_.show(request);
            pressed = show_buttons();
            pressed.opening = opening;
            for (const std::string& warning : shown.warnings)
                wrapped(text("Warning: ", warning), yellow);
            show_animation(session);
            lights_.show(session, request.asked.light_words);
            show_controls(session, request.asked);
        } catch (const Error& error) {
            pressed.refusal = error.what();
        }
        ImGui::PopItemWidth();
    }
    ImGui::End();
    return pressed;
}

// When a window appears or closes, Dear ImGui gives the keyboard focus to another window one or two frames later,
// although it was not clicked. This takes the focus away for some frames.
void Panels::release_keys()
{
    constexpr int frames = 4;
    const bool turned = std::exchange(was_open_, is_open) != is_open;
    if (std::exchange(had_help_, help) != help || turned)
        release_ = frames;
    if (release_ > 0) {
        --release_;
        ImGui::SetWindowFocus(nullptr);
    }
}

Pressed Panels::show(viewer::Session& session, const Shown& shown)
{
    release_keys();
    Pressed pressed;
    if (is_open)
        pressed = show_panel(session, shown);
    show_line(shown, pressed);
    show_messages(shown, ImGui::GetIO().DisplaySize.x - (is_open ? panel_width() : 0.0f));
    if (help)
        show_help(help);
    return pressed;
}

void Panels::leave()
{
    if (help)
        help = false;
    else
        ImGui::SetWindowFocus(nullptr);
}

} // namespace lambent::view_window
