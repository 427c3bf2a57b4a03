#include "apps/view/input_handler.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lambent::view_window {
namespace {

using viewer::OrbitCamera, viewer::Session, viewer::ViewRequest;
using Key = Window::Key;

// Degrees for a drag over the height of the window.
constexpr double degrees_across = 180.0;
constexpr double key_degrees = 5.0, key_dolly = 0.1, key_pan = 0.05, wheel_dolly = 0.12, key_exposure = 1.25;

double field_of_view(const ViewRequest& request)
{
    return viewer::number_in(request.asked, "fov");
}

void orbit(Session& session, double x, double y)
{
    session.change(0, [&](ViewRequest& request, const OrbitCamera::World&) { request.eye.orbit(x, y); });
}

void pan(Session& session, double x, double y)
{
    session.change(0, [&](ViewRequest& request, const OrbitCamera::World& world) {
        request.eye.pan(world, x, y, field_of_view(request));
    });
}

void dolly(Session& session, double by)
{
    session.change(
        0, [&](ViewRequest& request, const OrbitCamera::World& world) { request.eye.dolly(world, by); });
}

void turn(Session& session, double degrees)
{
    session.change(0, [&](ViewRequest& request, const OrbitCamera::World&) {
        viewer::turn_environment(request, degrees);
    });
}

void expose(Session& session, double factor)
{
    session.change(0, [&](ViewRequest& request, const OrbitCamera::World&) {
        viewer::set_nearest(request.asked, "exposure", viewer::number_in(request.asked, "exposure") * factor);
    });
}

void by_arrow(Session& session, const Key& key, Asked&)
{
    const int x = (key.key == GLFW_KEY_RIGHT) - (key.key == GLFW_KEY_LEFT),
              y = (key.key == GLFW_KEY_UP) - (key.key == GLFW_KEY_DOWN);
    if (key.shift)
        pan(session, -key_pan * x, -key_pan * y);
    else
        orbit(session, key_degrees * x, key_degrees * y);
}

void by_plus(Session& session, const Key& key, Asked&)
{
    dolly(session, key.character == '-' ? key_dolly : -key_dolly);
}

void by_bracket(Session& session, const Key& key, Asked&)
{
    turn(session, key.character == '[' ? -key_degrees : key_degrees);
}

void by_e(Session& session, const Key& key, Asked&)
{
    expose(session, key.shift ? 1.0 / key_exposure : key_exposure);
}

const std::array table = {
    Shortcut{"drag", "turn the view around the middle", "", {}},
    Shortcut{"right drag", "pan the view (or Ctrl and drag)", "", {}},
    Shortcut{"Shift, drag", "rotate the environment", "", {}},
    Shortcut{"wheel", "move closer or farther away", "", {}},
    Shortcut{"double click", "orbit around the point", "", {}},
    Shortcut{"arrows",
             "turn the view; with Shift pan it",
             "",
             {GLFW_KEY_LEFT, GLFW_KEY_RIGHT, GLFW_KEY_UP, GLFW_KEY_DOWN},
             false,
             true,
             by_arrow},
    Shortcut{"+ -", "move closer, farther away", "+=-", {}, false, true, by_plus},
    Shortcut{"[ ]", "rotate the environment", "[]", {}, false, true, by_bracket},
    Shortcut{"E, Shift E", "brighter, darker", "e", {}, false, true, by_e},
    Shortcut{"F",
             "orbit around the point in the middle",
             "f",
             {},
             false,
             false,
             [](Session& session, const Key&, Asked&) { session.focus(0.5, 0.5); }},
    Shortcut{"Space",
             "play or stop the animation",
             " ",
             {},
             false,
             false,
             [](Session& session, const Key&, Asked&) { session.play(0, !session.playing().on); }},
    Shortcut{"R",
             "reset everything",
             "r",
             {},
             false,
             false,
             [](Session& session, const Key&, Asked&) { session.reset(0); }},
    Shortcut{"S",
             "save the picture as PNG",
             "s",
             {},
             false,
             false,
             [](Session&, const Key&, Asked& asked) { asked.save = true; }},
    Shortcut{"C",
             "copy the command that draws the picture",
             "c",
             {},
             false,
             false,
             [](Session&, const Key&, Asked& asked) { asked.copy = true; }},
    Shortcut{"P",
             "show or hide the panel",
             "p",
             {},
             false,
             false,
             [](Session&, const Key&, Asked& asked) { asked.panel ^= true; }},
    Shortcut{"F1, ?",
             "show or hide this list",
             "?",
             {GLFW_KEY_F1},
             false,
             false,
             [](Session&, const Key&, Asked& asked) { asked.help ^= true; }},
    Shortcut{"Escape",
             "close this list, or leave the panel",
             "",
             {GLFW_KEY_ESCAPE},
             false,
             false,
             [](Session&, const Key&, Asked& asked) { asked.leave = true; }},
    Shortcut{"Ctrl Q",
             "close the window",
             "q",
             {},
             true,
             false,
             [](Session&, const Key&, Asked& asked) { asked.close = true; }},
};

bool is_for(const Shortcut& shortcut, const Key& key)
{
    const bool named = key.character ? shortcut.characters.find(key.character) != std::string_view::npos
                                     : std::find(shortcut.others.begin(), shortcut.others.end(), key.key) !=
                                           shortcut.others.end();
    return shortcut.act && named && shortcut.control == key.control && (shortcut.repeats || !key.repeated);
}

// Whether Dear ImGui uses the key: text input, and arrows while a control of the panel has the keyboard focus.
bool is_for_controls(const Key& key)
{
    const ImGuiIO& io = ImGui::GetIO();
    if (key.control)
        return false;
    if (io.WantTextInput || ImGui::IsAnyItemActive())
        return true;
    return !key.character && key.key != GLFW_KEY_F1 && key.key != GLFW_KEY_ESCAPE && io.WantCaptureKeyboard;
}

} // namespace

std::span<const Shortcut> shortcuts()
{
    return table;
}

void move_by_mouse(Session& session)
{
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse || !ImGui::IsMousePosValid())
        return;
    const double height = std::fmax(static_cast<double>(io.DisplaySize.y), 1.0);
    const double x = static_cast<double>(io.MouseDelta.x) / height,
                 y = static_cast<double>(io.MouseDelta.y) / height;
    if (io.MouseWheel != 0.0f)
        dolly(session, -wheel_dolly * static_cast<double>(io.MouseWheel));
    if (ImGui::IsMouseDoubleClicked(0))
        session.focus(static_cast<double>(io.MousePos.x / io.DisplaySize.x),
                      static_cast<double>(io.MousePos.y / io.DisplaySize.y));
    if (x == 0.0 && y == 0.0)
        return;
    if (io.MouseDown[1] || io.MouseDown[2] || (io.MouseDown[0] && io.KeyCtrl))
        pan(session, x, -y);
    else if (io.MouseDown[0] && io.KeyShift)
        turn(session, x * degrees_across);
    else if (io.MouseDown[0])
        orbit(session, -x * degrees_across, y * degrees_across);
}

Asked press_keys(Session& session, const std::vector<Key>& keys)
{
    Asked asked;
    for (const Key& key : keys) {
        const auto shortcut =
            std::find_if(table.begin(), table.end(), [&](const Shortcut& row) { return is_for(row, key); });
        if (shortcut != table.end() && !is_for_controls(key))
            shortcut->act(session, key, asked);
    }
    return asked;
}

} // namespace lambent::view_window
