// The built-in environment "sky".
#pragma once

#include "environment/builtin.h"

namespace lambent::environment {

/// Options within their ranges, as make_builtin checks.
image::RadianceImage make_sky(const BuiltinOptions& options);

} // namespace lambent::environment
