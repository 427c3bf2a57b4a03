// The prefilter of environments that a command line asks for: on the CPU or on a Vulkan device.
#pragma once

#include "apps/options/arguments.h"
#include "environment/bake/prefilter_faces.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace lambent::cli {

struct Filler {
    environment::FillFaces fill;
    std::string backend, device; ///< names to print; on the CPU `device` is empty
    std::shared_ptr<bool>
        given_up; ///< true once the device failed and the CPU took over; null: it never does

    /// Milliseconds on the device so far; nothing on the CPU.
    std::function<std::optional<double>()> milliseconds;
};

/// Backend::automatic: a hardware device that works, else the CPU; `warn` gets one line about a device that fails.
/// Throws Error(no_device), with Backend::vulkan also if this program was built without Vulkan.
Filler make_filler(const BakeArguments& arguments, const std::function<void(const std::string&)>& warn);

} // namespace lambent::cli
