// Small scenes of random shapes, materials, lights and cameras, for comparing renderers.
#pragma once

#include "image/image.h"
#include "scene/scene.h"
#include "view/picture.h"

#include <cstdint>
#include <string>

namespace lambent::testing {

/// What a picture needs but its renderer's own settings.
struct RandomScene {
    scene::Scene scene;
    image::RadianceImage panorama; ///< black where `dark`
    bool dark = false;             ///< there is no environment
    view::Picture picture;         ///< without background
    int bounces = 1;               ///< 1 to 4
    std::string words;             ///< what is in it, for messages
};

/// The same for the same number, on every machine with the same mathematics library.
RandomScene random_scene(std::uint32_t number, int width, int height);

} // namespace lambent::testing
