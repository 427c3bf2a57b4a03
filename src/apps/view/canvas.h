// The picture, drawn as a texture behind all controls.
#pragma once

#include "image/image.h"

namespace lambent::view_window {

/// Needs the window's OpenGL context to be current, in the destructor as well.
class Canvas {
public:
    Canvas();
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// Takes a picture with 8-bit codes and 3 or 4 channels.
    void set(const image::CodeImage& picture);

    /// Fills the window with the picture, which is filtered where it has fewer pixels.
    void draw() const;

private:
    unsigned texture_ = 0;
    bool filled_ = false;
};

} // namespace lambent::view_window
