// The columns of the G-buffer (shading/columns.glsl) as C++ constants.
#pragma once

namespace lambent::draw {

#include "shading/numbers.glsl"

} // namespace lambent::draw
