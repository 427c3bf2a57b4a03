// Work on a graphics device where there is one, and what else to do where there is none.
#pragma once

#include "vulkan/api.h"
#include "vulkan/hardware.h"

#include <functional>
#include <string>

namespace lambent::draw {

/// What `make` makes, a pointer; null where there is no hardware to make it on, and, after `warn` was told why, where the
/// hardware fails.
template <class Make>
auto on_hardware(const Make& make, const std::function<void(const std::string&)>& warn) -> decltype(make())
{
    if (!vulkan::may_have_hardware())
        return nullptr;
    try {
        return make();
    } catch (const vulkan::NoSuchDevice&) {
    } catch (const Error& error) {
        if (error.failure() != Failure::no_device)
            throw;
        warn(error.what());
    }
    return nullptr;
}

} // namespace lambent::draw
