// A window with an OpenGL 3 context and Dear ImGui.
#pragma once

#include "apps/view/window_place.h"

#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace lambent::view_window {

class Window {
public:
    /// Throws Error(no_device) if there is no display or no OpenGL.
    Window(const std::string& title, const WindowPlace& place);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    void set_title(const std::string& title) const;
    void copy(const std::string& text) const; ///< to the clipboard

    /// Whether the desktop or close() asked to close the window; stay() withdraws that.
    bool closing() const;
    void close() const;
    void stay() const;

    /// The position and size, those before maximising if it is maximised.
    WindowPlace place() const;

    /// The size in pixels, of which a screen unit may have several.
    struct Pixels {
        int width = 1, height = 1;
    };
    Pixels pixels() const;

    /// Handles events; waits up to `seconds` for the first one if that is above 0. Returns false if none came in that
    /// time.
    bool listen(double seconds);

    /// Begin and end a frame: controls of Dear ImGui go in between, and are drawn over what was drawn before end().
    void begin();
    void end();

    /// Sets the content scale of text and controls: 1 on usual screens, 2 on those with twice the pixel density.
    void set_scale(float scale) { wanted_scale_ = scale; }

    /// A typed key: a lower-case character, or else GLFW_KEY_*. Dear ImGui is not used for this, as it identifies keys
    /// by their position on a US keyboard.
    struct Key {
        char character = 0;
        int key = 0;
        bool shift = false, control = false, repeated = false;
    };
    std::vector<Key> take_keys() { return std::exchange(keys_, {}); }

    /// Names of files that were dropped onto the window.
    std::vector<std::string> take_dropped() { return std::exchange(dropped_, {}); }

    /// Ends the wait in listen(). Any thread.
    static void wake();

private:
    void set_callbacks();
    void note_key(int key, int code, bool repeated, int modifiers);
    void note_character(unsigned character);
    void note_place();
    void fit_letters();
    void press_again();
    void let_go();

    GLFWwindow* window_ = nullptr;
    WindowPlace place_;
    float wanted_scale_ = 1.0f, scale_ = 0.0f, density_ = 0.0f;
    Key last_key_;
    std::vector<Key> keys_;
    std::vector<int> pressed_; ///< since the last frame
    std::vector<std::string> dropped_;
};

} // namespace lambent::view_window
