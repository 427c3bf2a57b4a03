// The part of a picture in which a scene can be seen.
#pragma once

#include "scene/scene.h"
#include "view/camera.h"

namespace lambent::view {

/// Pixels from (x, y) on.
struct PixelArea {
    int x = 0, y = 0, width = 0, height = 0;
};

/// An area of the picture that holds all pixels in which anything within `bounds` can be seen, and at least one pixel: the
/// rectangle around the corners of `bounds`; the whole picture if one of them is not in front of the camera.
PixelArea covered_area(const scene::Bounds& bounds, const RayMap& rays, int width, int height);

} // namespace lambent::view
