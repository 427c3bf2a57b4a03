// A renderer on a device that may fail, with a fallback.
#pragma once

#include "draw/renderer.h"

#include <functional>
#include <memory>
#include <string>

namespace lambent::draw {

/// Draws with `device` until it throws Error(no_device), because the device is lost or out of memory. The message is
/// passed to `warn`, and the renderer from `make_other` takes over in the last pose, beginning with the picture that
/// failed. Other exceptions are passed on.
std::unique_ptr<Renderer> make_rescued_renderer(std::unique_ptr<Renderer> device,
                                                std::function<std::unique_ptr<Renderer>()> make_other,
                                                std::function<void(const std::string&)> warn);

} // namespace lambent::draw
