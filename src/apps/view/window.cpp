#include "apps/view/window.h"

#include "base/error.h"
#include "base/text.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace lambent::view_window {
namespace {

constexpr float letter_pixels = 15.0f;

std::string reason()
{
    const char* words = nullptr;
    glfwGetError(&words);
    return words ? one_line(words) : std::string("no reason was given");
}

Error no_window(const std::string& why)
{
    return {Failure::no_device,
            text("no window can be opened: ", why, "; use lambent serve in a browser instead")};
}

std::vector<WorkArea> work_areas()
{
    int count = 0;
    GLFWmonitor** const monitors = glfwGetMonitors(&count);
    std::vector<WorkArea> areas(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < areas.size(); ++i)
        glfwGetMonitorWorkarea(monitors[i], &areas[i].x, &areas[i].y, &areas[i].width, &areas[i].height);
    return areas;
}

// Creates the window hidden and shows it once it is placed, so that it does not jump.
GLFWwindow* make_window(const std::string& title, const WindowPlace& place)
{
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow* const window = glfwCreateWindow(place.width, place.height, title.c_str(), nullptr, nullptr);
    if (!window)
        return nullptr;
    glfwSetWindowSizeLimits(window, 320, 240, GLFW_DONT_CARE, GLFW_DONT_CARE);
    if (place.corner)
        glfwSetWindowPos(window, place.corner->x, place.corner->y);
    if (place.maximised)
        glfwMaximizeWindow(window);
    glfwShowWindow(window);
    return window;
}

void start_gui(GLFWwindow* window)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // settings are kept by window_settings.h instead
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 130");
}

Window& own(GLFWwindow* window)
{
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

} // namespace

Window::Window(const std::string& title, const WindowPlace& place) : place_(place)
{
    if (glfwInit() != GLFW_TRUE)
        throw no_window(reason());
    place_ = reachable(place, work_areas());
    window_ = make_window(title, place_);
    if (!window_) {
        const std::string why = reason();
        glfwTerminate();
        throw no_window(why);
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    set_callbacks();
    start_gui(window_);
    glfwGetWindowContentScale(window_, &wanted_scale_, nullptr);
}

// To be called before Dear ImGui installs its callbacks, which call these.
void Window::set_callbacks()
{
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int code, int action, int modifiers) {
        if (action != GLFW_RELEASE)
            own(window).note_key(key, code, action == GLFW_REPEAT, modifiers);
    });
    glfwSetCharCallback(
        window_, [](GLFWwindow* window, unsigned character) { own(window).note_character(character); });
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** names) {
        std::vector<std::string>& dropped = own(window).dropped_;
        dropped.insert(dropped.end(), names, names + count);
    });
    glfwSetWindowContentScaleCallback(
        window_, [](GLFWwindow* window, float scale, float) { own(window).set_scale(scale); });
}

// Printable keys arrive as characters in the keyboard's layout, except while Control is held: then the key's name is
// used.
void Window::note_key(int key, int code, bool repeated, int modifiers)
{
    pressed_.push_back(key);
    last_key_ = {0, key, (modifiers & GLFW_MOD_SHIFT) != 0, (modifiers & GLFW_MOD_CONTROL) != 0, repeated};
    const char* const name = glfwGetKeyName(key, code);
    if (!name)
        keys_.push_back(last_key_);
    if (!name || !last_key_.control)
        return;
    Key typed = last_key_;
    typed.character = static_cast<unsigned char>(name[0]) < 0x80 ? name[0] : '\0';
    if (!typed.character && key >= GLFW_KEY_A && key <= GLFW_KEY_Z)
        typed.character = static_cast<char>(key - GLFW_KEY_A + 'a');
    keys_.push_back(typed);
}

// In layouts without Latin letters the key's position on a US keyboard gives the letter.
void Window::note_character(unsigned character)
{
    Key typed = last_key_;
    if (character < 0x80)
        typed.character = static_cast<char>(character);
    else if (typed.key >= GLFW_KEY_A && typed.key <= GLFW_KEY_Z)
        typed.character = static_cast<char>(typed.key);
    if (typed.character >= 'A' && typed.character <= 'Z')
        typed.character = static_cast<char>(typed.character - 'A' + 'a');
    if (typed.character)
        keys_.push_back(typed);
}

Window::~Window()
{
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::set_title(const std::string& title) const
{
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::copy(const std::string& text) const
{
    glfwSetClipboardString(window_, text.c_str());
}

bool Window::closing() const
{
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void Window::close() const
{
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::stay() const
{
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
}

WindowPlace Window::place() const
{
    return place_;
}

// The position and size before maximising or minimising are kept, to return to.
void Window::note_place()
{
    place_.maximised = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE;
    if (place_.maximised || glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE)
        return;
    glfwGetWindowSize(window_, &place_.width, &place_.height);
    glfwGetError(nullptr);
    WindowPlace::Corner corner;
    glfwGetWindowPos(window_, &corner.x, &corner.y);
    // Some desktops, such as Wayland, do not tell positions.
    if (glfwGetError(nullptr) == GLFW_NO_ERROR)
        place_.corner = corner;
}

Window::Pixels Window::pixels() const
{
    Pixels pixels;
    glfwGetFramebufferSize(window_, &pixels.width, &pixels.height);
    return pixels;
}

bool Window::listen(double seconds)
{
    const auto start = std::chrono::steady_clock::now();
    if (seconds > 0.0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
    note_place();
    return std::chrono::steady_clock::now() - start < std::chrono::duration<double>(seconds);
}

void Window::wake()
{
    glfwPostEmptyEvent();
}

// Fonts are sized in pixels, controls in screen units of `density` pixels each.
void Window::fit_letters()
{
    int width = 0;
    glfwGetWindowSize(window_, &width, nullptr);
    const float density = width > 0 ? static_cast<float>(pixels().width) / static_cast<float>(width)
                                    : std::fmax(density_, 1.0f);
    const float scale = std::isfinite(wanted_scale_) ? std::clamp(wanted_scale_, 0.5f, 8.0f) : 1.0f;
    if (scale == scale_ && density == density_)
        return;
    scale_ = scale;
    density_ = density;
    ImGuiIO& io = ImGui::GetIO();
    ImFontConfig font;
    font.SizePixels = std::round(letter_pixels * scale);
    io.Fonts->Clear();
    io.Fonts->AddFontDefault(&font);
    io.FontGlobalScale = 1.0f / density;
    ImGuiStyle style;
    style.ScaleAllSizes(scale / density);
    ImGui::GetStyle() = style;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Window::begin()
{
    ImGui_ImplOpenGL3_NewFrame(); // makes the font texture, which fit_letters() replaces
    fit_letters();
    ImGui_ImplGlfw_NewFrame();
    press_again();
    ImGui::NewFrame();
}

// Reports keys that were pressed and released within one frame as pressed for that frame, with their modifiers.
void Window::press_again()
{
    ImGuiIO& io = ImGui::GetIO();
    for (const int key : pressed_)
        if (key >= 0 && key <= GLFW_KEY_LAST)
            io.KeysDown[key] = true;
    io.KeyCtrl |= !pressed_.empty() && last_key_.control;
    io.KeyShift |= !pressed_.empty() && last_key_.shift;
}

void Window::let_go()
{
    ImGuiIO& io = ImGui::GetIO();
    const auto is_down = [&](int key) { return glfwGetKey(window_, key) == GLFW_PRESS; };
    for (const int key : std::exchange(pressed_, {}))
        if (key >= 0 && key <= GLFW_KEY_LAST)
            io.KeysDown[key] = is_down(key);
    io.KeyCtrl = is_down(GLFW_KEY_LEFT_CONTROL) || is_down(GLFW_KEY_RIGHT_CONTROL);
    io.KeyShift = is_down(GLFW_KEY_LEFT_SHIFT) || is_down(GLFW_KEY_RIGHT_SHIFT);
}

void Window::end()
{
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_);
    let_go();
}

} // namespace lambent::view_window
