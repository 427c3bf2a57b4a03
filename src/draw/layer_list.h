// The layers a picture can be taken apart into, and which columns of the G-buffer hold them.
#pragma once

#include "draw/columns.h"
#include "draw/frame.h"
#include "draw/settings.h"

#include <vector>

namespace lambent::draw {

/// What a layer shows of its columns: one, three times; three; the square root of one, three times.
enum class Reading { one, three, root };

struct LayerSource {
    const char* name;
    Layer::Kind kind;
    int first; ///< the column, or the first of three
    Reading reading;
};

/// Every layer but the background, in the order in which a picture is made.
std::vector<LayerSource> layer_sources(Model model);

/// Name of the light layer of what lies behind all surfaces.
constexpr const char* background_layer = "light_background";

} // namespace lambent::draw
