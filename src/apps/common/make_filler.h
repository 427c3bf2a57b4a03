// Who prefilters an environment, as a command line asks for it.
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
    std::string backend, device; ///< for people; the processors have no device
    std::shared_ptr<bool>
        given_up; ///< set when the device failed and the processors went on; null: that cannot be

    /// Milliseconds on the device so far; none of the processors.
    std::function<std::optional<double>()> milliseconds;
};

/// Backend::automatic: hardware where there is some and it works, else the processor, after `warn` was told in one line
/// what failed. Throws Error(no_device), with Backend::vulkan also where this program was built without it.
Filler make_filler(const BakeArguments& arguments, const std::function<void(const std::string&)>& warn);

} // namespace lambent::cli
