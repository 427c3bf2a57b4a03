// A window on the screen, with OpenGL 3 in it and Dear ImGui over it.
#pragma once

#include "apps/view/window_place.h"

#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace lambent::view_window {

class Window {
public:
    /// Throws Error(no_device) where there is no display or no OpenGL.
    Window(const std::string& title, const WindowPlace& place);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    void set_title(const std::string& title) const;
    void copy(const std::string& text) const; ///< to the clipboard

    /// Whether the desktop or close() asked for the end, unless stay() came after it.
    bool closing() const;
    void close() const;
    void stay() const;

    /// Where it stands, or stood before it was maximised.
    WindowPlace place() const;

    /// In pixels, of which a unit of the screen may have several.
    struct Pixels {
        int width = 1, height = 1;
    };
    Pixels pixels() const;

    /// Takes what happened; if `seconds` is above 0, waits so long for something. False: nothing happened in this time.
    bool listen(double seconds);

    /// Everything of Dear ImGui between these two is shown, over what was drawn before end().
    void begin();
    void end();

    /// Letters and controls for another content scale: 1 on usual screens, 2 on dense ones.
    void set_scale(float scale) { wanted_scale_ = scale; }

    /// What was typed: a character in small letters, or else a key, GLFW_KEY_*. Dear ImGui knows keys only by their
    /// places on an American keyboard.
    struct Key {
        char character = 0;
        int key = 0;
        bool shift = false, control = false, repeated = false;
    };
    std::vector<Key> take_keys() { return std::exchange(keys_, {}); }

    /// Names of files that were dropped.
    std::vector<std::string> take_dropped() { return std::exchange(dropped_, {}); }

    /// Ends waiting, from any thread.
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
