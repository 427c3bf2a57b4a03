// The layers that can be returned with a picture, and the columns of the G-buffer that hold them.
#pragma once

#include "draw/columns.h"
#include "draw/frame.h"
#include "draw/settings.h"

#include <vector>

namespace lambent::draw {

/// How a layer's R, G and B are read: all from one column; from three columns; all as the square root of one column.
enum class Reading { one, three, root };

struct LayerSource {
    const char* name;
    Layer::Kind kind;
    int first; ///< number of the column, or of the first of three
    Reading reading;
};

/// All layers except that of the background, in the order of Frame::layers.
std::vector<LayerSource> layer_sources(Model model);

/// Name of the layer with the light of the background, which comes last.
constexpr const char* background_layer = "light_background";

} // namespace lambent::draw
