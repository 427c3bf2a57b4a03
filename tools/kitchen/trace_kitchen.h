// Traces the built-in environment `kitchen`.
#pragma once

#include "image/image.h"

#include <functional>
#include <limits>

namespace lambent {

struct KitchenTrace {
    int width = 2048, height = 1024;
    double seconds = std::numeric_limits<double>::infinity(); ///< stop after this time, or at one of these:
    double noise = 0.0;    ///< estimated relative RMSE, see reference::Settings
    int samples = 1 << 20; ///< per pixel
    int bounces = 5;       ///< later ones hold 2 % of the light and take a third of the time
    bool smooth = true;    ///< remove noise (smooth.h)
};

struct KitchenPicture {
    image::RadianceImage radiance; ///< RGB, in units of kitchen::exposure
    double sky_noise = 0.0, sun_noise = 0.0;
    double sky_samples = 0.0, sun_samples = 0.0;
};

/// Traces sky light (with the lamps) and sunlight one after the other, each for half of the time, and adds them: traced
/// together, nine of ten samples would go to the sun, which few points see. `report` is called with the share done,
/// from 0 to 1.
KitchenPicture trace_kitchen(const KitchenTrace& trace, const std::function<void(double)>& report = {});

} // namespace lambent
