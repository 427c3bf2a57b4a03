// What the G-buffer holds: the columns of shading/columns.glsl.
#pragma once

namespace lambent::draw {

#include "shading/numbers.glsl"

} // namespace lambent::draw
