// What things in the kitchen are made of.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace lambent::kitchen {

/// Materials; those called plain are white and get their colour from a tint.
enum class Stuff {
    plaster, ///< walls and ceiling, plain
    wood,    ///< oiled, with grain, plain
    lacquer, ///< satin paint on boards, plain
    marble,
    stone,  ///< counters: grey and satin
    steel,  ///< brushed
    chrome, ///< a little worn: no perfect mirrors, they would be noise
    brass,
    black_glass,
    black,   ///< powder-coated metal, and shadow gaps
    tile,    ///< glazed, plain
    ceramic, ///< plain
    glass,   ///< of bottles and jars: opaque, plain
    fruit,   ///< waxy, plain
    leaf,    ///< plain
    cloth,   ///< plain
    rug,
    bulb,  ///< warm light, of lamps
    strip, ///< warm light, under cabinets
    spot,  ///< neutral light, in the ceiling
    count
};

/// One for each Stuff, in its order; their images are to be the scene's.
struct Stuffs {
    std::vector<scene::Material> materials;
    std::vector<image::CodeImage> images;
};
Stuffs make_stuffs();

} // namespace lambent::kitchen
