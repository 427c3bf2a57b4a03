// The built-in environment `kitchen`, from scene to light.
#pragma once

#include "image/image.h"

#include <functional>
#include <limits>

namespace lambent {

struct KitchenTrace {
    int width = 2048, height = 1024;
    double seconds = std::numeric_limits<double>::infinity(); ///< stop after this time, or at:
    double noise = 0.0;    ///< estimated relative RMSE, see reference::Settings
    int samples = 1 << 20; ///< per pixel
    int bounces = 5;       ///< what comes after is 2 % of the light, at a third of the time
    bool smooth = true;    ///< take noise out (smooth.h)
};

struct KitchenPicture {
    image::RadianceImage radiance; ///< RGB, in units of kitchen::exposure
    double sky_noise = 0.0, sun_noise = 0.0;
    double sky_samples = 0.0, sun_samples = 0.0;
};

/// Sky light (with the lamps) and sun light are traced one after the other and added: drawn together, nine of ten
/// samples would go to the sun, which few points see. Each takes half of the time. `report` is called now and then with
/// what share is done.
KitchenPicture trace_kitchen(const KitchenTrace& trace, const std::function<void(double)>& report = {});

} // namespace lambent
