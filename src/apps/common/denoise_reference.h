// The noise of a path-traced picture, filtered out.
#pragma once

#include "image/image.h"
#include "reference/tracer.h"

namespace lambent::cli {

/// The filtered picture, RGBA as Result::radiance, whose coverage and unlit part it keeps. The result must have its
/// first surfaces (reference::Settings::first_surfaces). At 640x360 cheap enough for every second (docs/FILTER.md).
/// Throws std::bad_alloc.
image::RadianceImage denoised(const reference::Result& traced);

} // namespace lambent::cli
