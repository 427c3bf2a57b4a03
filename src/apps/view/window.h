// A window on the screen, with OpenGL 3 in it and Dear ImGui over it.
#pragma once

#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace lambent::view_window {

struct WindowPlace {
    int width = 1280, height = 720; ///< in the units of the screen
};

class Window {
public:
    /// Throws Error(no_device) where there is no display or no OpenGL.
    Window(const std::string& title, const WindowPlace& place);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    bool closing() const;
    WindowPlace place() const;

    /// In pixels, of which a unit of the screen may have several.
    struct Pixels {
        int width = 1, height = 1;
    };
    Pixels pixels() const;

    /// Waits for something to happen, at most so many seconds.
    void wait(double seconds) const;

    /// Everything of Dear ImGui between these two is shown, over what was drawn before end().
    void begin() const;
    void end() const;

    /// A key that went down, or repeats; GLFW_KEY_*. Dear ImGui would miss one that is up again by the next frame.
    struct Key {
        int key = 0;
        bool shift = false, control = false;
    };
    std::vector<Key> take_keys() { return std::exchange(keys_, {}); }

    /// Names of files that were dropped.
    std::vector<std::string> take_dropped() { return std::exchange(dropped_, {}); }

    /// Ends wait(), from any thread.
    static void wake();

private:
    void listen();

    GLFWwindow* window_ = nullptr;
    std::vector<Key> keys_;
    std::vector<std::string> dropped_;
};

} // namespace lambent::view_window
