// Objects that are made on a graphics device, if there is one.
#pragma once

#include "vulkan/api.h"
#include "vulkan/hardware.h"

#include <functional>
#include <string>

namespace lambent::draw {

/// Returns the pointer that `make` returns; null if there is no graphics hardware. If the hardware fails
/// (Error(no_device)), passes the message to `warn` and returns null. Other exceptions are passed on.
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
