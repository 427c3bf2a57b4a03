// The materials of the kitchen.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace lambent::kitchen {

/// Materials. Those marked plain are white and get their colour from a tint.
enum class Stuff {
    plaster, ///< walls and ceiling, plain
    wood,    ///< oiled, with grain, plain
    lacquer, ///< satin paint on boards, plain
    marble,
    stone,  ///< counters: grey and satin
    steel,  ///< brushed
    chrome, ///< a little worn: perfect mirrors would be noisy
    brass,
    black_glass,
    black,   ///< powder-coated metal, and shadow gaps
    tile,    ///< glazed, plain
    ceramic, ///< plain
    glass,   ///< for bottles and jars: opaque, plain
    fruit,   ///< waxy, plain
    leaf,    ///< plain
    cloth,   ///< plain
    rug,
    bulb,  ///< warm light, of lamps
    strip, ///< warm light, under cabinets
    spot,  ///< neutral light, in the ceiling
    count
};

/// One material for each Stuff, in its order. Their image indices refer to the images, which the scene must have.
struct Stuffs {
    std::vector<scene::Material> materials;
    std::vector<image::CodeImage> images;
};
Stuffs make_stuffs();

} // namespace lambent::kitchen
