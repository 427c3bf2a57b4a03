// The picture as a texture behind all controls.
#pragma once

#include "image/image.h"

namespace lambent::view_window {

/// Lives in the window's OpenGL context.
class Canvas {
public:
    Canvas();
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// 8-bit codes.
    void set(const image::CodeImage& picture);

    /// Fills the window; smooth where the picture has fewer pixels.
    void draw() const;

private:
    unsigned texture_ = 0;
    bool filled_ = false;
};

} // namespace lambent::view_window
