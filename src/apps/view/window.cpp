#include "apps/view/window.h"

#include "base/error.h"
#include "base/text.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace lambent::view_window {
namespace {

std::string reason()
{
    const char* words = nullptr;
    glfwGetError(&words);
    return words ? one_line(words) : std::string("no reason was given");
}

// Letters of the size that the screen asks for.
void start_gui(GLFWwindow* window)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // what is remembered is memory.h's
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    float scale = 1.0f;
    glfwGetWindowContentScale(window, &scale, nullptr);
    ImFontConfig font;
    font.SizePixels = 15.0f * scale;
    io.Fonts->AddFontDefault(&font);
    ImGui::GetStyle().ScaleAllSizes(scale);
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 130");
}

} // namespace

Window::Window(const std::string& title, const WindowPlace& place)
{
    if (glfwInit() != GLFW_TRUE)
        throw Error(Failure::no_device, text("no window can be opened: ", reason(),
                                             "; lambent serve shows the same in a browser"));
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    window_ = glfwCreateWindow(place.width, place.height, title.c_str(), nullptr, nullptr);
    if (!window_) {
        const std::string why = reason();
        glfwTerminate();
        throw Error(Failure::no_device, text("no window can be opened: ", why));
    }
    glfwSetWindowSizeLimits(window_, 320, 240, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    listen();
    start_gui(window_);
}

// Before Dear ImGui, which calls on.
void Window::listen()
{
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int modifiers) {
        if (action != GLFW_RELEASE)
            static_cast<Window*>(glfwGetWindowUserPointer(window))
                ->keys_.push_back(
                    {key, (modifiers & GLFW_MOD_SHIFT) != 0, (modifiers & GLFW_MOD_CONTROL) != 0});
    });
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** names) {
        std::vector<std::string>& dropped = static_cast<Window*>(glfwGetWindowUserPointer(window))->dropped_;
        dropped.insert(dropped.end(), names, names + count);
    });
}

Window::~Window()
{
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

bool Window::closing() const
{
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

WindowPlace Window::place() const
{
    WindowPlace place;
    glfwGetWindowSize(window_, &place.width, &place.height);
    return place;
}

Window::Pixels Window::pixels() const
{
    Pixels pixels;
    glfwGetFramebufferSize(window_, &pixels.width, &pixels.height);
    return pixels;
}

void Window::wait(double seconds) const
{
    glfwWaitEventsTimeout(seconds);
}

void Window::wake()
{
    glfwPostEmptyEvent();
}

void Window::begin() const
{
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Window::end() const
{
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_);
}

} // namespace lambent::view_window
