#include "apps/view/hands.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace lambent::view_window {
namespace {

using viewer::Eye, viewer::Session, viewer::Wish;

// A drag over the window's height.
constexpr double degrees_across = 180.0;
constexpr double key_degrees = 5.0, key_dolly = 0.1, key_pan = 0.05, wheel_dolly = 0.12, key_exposure = 1.25;

double field_of_view(const Wish& wish)
{
    return std::stod(wish.values["fov"]);
}

void orbit(Session& session, double x, double y)
{
    session.change(0, [&](Wish& wish, const Eye::World&) { wish.eye.orbit(x, y); });
}

void pan(Session& session, double x, double y)
{
    session.change(
        0, [&](Wish& wish, const Eye::World& world) { wish.eye.pan(world, x, y, field_of_view(wish)); });
}

void dolly(Session& session, double by)
{
    session.change(0, [&](Wish& wish, const Eye::World& world) { wish.eye.dolly(world, by); });
}

void turn(Session& session, double degrees)
{
    session.change(0, [&](Wish& wish, const Eye::World&) { viewer::turn_environment(wish, degrees); });
}

void expose(Session& session, double factor)
{
    session.change(0, [&](Wish& wish, const Eye::World&) {
        const double exposure = std::stod(wish.values["exposure"]) * factor;
        wish.values.set("exposure", viewer::number_word(
                                        std::clamp(exposure, viewer::least_exposure, viewer::most_exposure)));
    });
}

void move_by_mouse(Session& session)
{
    const ImGuiIO& io = ImGui::GetIO();
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

void arrow(Session& session, int x, int y, bool shift)
{
    if (shift)
        pan(session, -key_pan * x, -key_pan * y);
    else
        orbit(session, key_degrees * x, key_degrees * y);
}

// Keys that move something; whether this was one.
bool move_by_key(Session& session, const Window::Key& key)
{
    switch (key.key) {
    case GLFW_KEY_RIGHT:
        return arrow(session, 1, 0, key.shift), true;
    case GLFW_KEY_LEFT:
        return arrow(session, -1, 0, key.shift), true;
    case GLFW_KEY_UP:
        return arrow(session, 0, 1, key.shift), true;
    case GLFW_KEY_DOWN:
        return arrow(session, 0, -1, key.shift), true;
    case GLFW_KEY_EQUAL:
    case GLFW_KEY_KP_ADD:
        return dolly(session, -key_dolly), true;
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT:
        return dolly(session, key_dolly), true;
    case GLFW_KEY_LEFT_BRACKET:
        return turn(session, -key_degrees), true;
    case GLFW_KEY_RIGHT_BRACKET:
        return turn(session, key_degrees), true;
    case GLFW_KEY_E:
        return expose(session, key.shift ? 1.0 / key_exposure : key_exposure), true;
    case GLFW_KEY_F:
        return session.focus(0.5, 0.5), true;
    case GLFW_KEY_R:
        return session.reset(0), true;
    default:
        return false;
    }
}

void ask_by_key(const Window::Key& key, Asked& asked)
{
    asked.save |= key.key == GLFW_KEY_S;
    asked.copy |= key.key == GLFW_KEY_C;
    asked.panel ^= key.key == GLFW_KEY_P;
    asked.help ^= key.key == GLFW_KEY_F1 || (key.key == GLFW_KEY_SLASH && key.shift);
}

} // namespace

const char* const hand_help = "drag             turn around what is in the middle\n"
                              "right drag       move it aside (or Ctrl and drag)\n"
                              "wheel, + and -   nearer and further\n"
                              "double click, F  what is there becomes the middle\n"
                              "Shift and drag   turn the environment ([ and ])\n"
                              "arrows           turn; with Shift move aside\n"
                              "E, Shift E       brighter, darker\n"
                              "S                save the picture\n"
                              "C                copy the command that draws it\n"
                              "P                show or hide the panel\n"
                              "R                everything as at the start\n"
                              "F1, ?            this\n"
                              "Ctrl Q           close\n"
                              "Drop a .gltf or .glb, or an .hdr or .exr, to open it.";

Asked move(Session& session, const std::vector<Window::Key>& keys)
{
    const ImGuiIO& io = ImGui::GetIO();
    Asked asked;
    if (!io.WantCaptureMouse)
        move_by_mouse(session);
    for (const Window::Key& key : keys) {
        asked.close |= key.control && key.key == GLFW_KEY_Q;
        if (!io.WantTextInput && !key.control && !move_by_key(session, key))
            ask_by_key(key, asked);
    }
    return asked;
}

} // namespace lambent::view_window
