// A renderer on a device that may fail, and another that goes on.
#pragma once

#include "draw/renderer.h"

#include <functional>
#include <memory>
#include <string>

namespace lambent::draw {

/// Draws by `device` until that throws Error(no_device), as one that is lost or has no memory left does. What it said is
/// passed to `warn`, and from then on what `make_other` makes draws, the picture that failed first, in the pose asked for
/// last. All else that drawing throws is passed on.
std::unique_ptr<Renderer> make_rescued_renderer(std::unique_ptr<Renderer> device,
                                                std::function<std::unique_ptr<Renderer>()> make_other,
                                                std::function<void(const std::string&)> warn);

} // namespace lambent::draw
