#include "apps/cli/make_filler.h"

#include "base/error.h"

#ifdef LAMBENT_VULKAN
#include "apps/cli/device_options.h"
#include "draw/vulkan/device_prefilter.h"

#include <memory>
#include <numeric>
#endif

namespace lambent::cli {

Filler make_filler(const BakeArguments& arguments)
{
    if (arguments.backend != Backend::vulkan)
        return {environment::prefilter_faces, "cpu", {}, [] { return std::nullopt; }};
#ifdef LAMBENT_VULKAN
    const auto device = std::make_shared<draw::DevicePrefilter>(device_options(arguments.cache));
    return {[device](const auto& faces, const auto& report) { device->fill(faces, report); }, "vulkan",
            device->device(),
            [device] {
                const std::vector<double>& all = device->milliseconds();
                return std::optional(std::accumulate(all.begin(), all.end(), 0.0));
            }};
#else
    throw Error(Failure::no_device, "--backend vulkan: this program was built without Vulkan");
#endif
}

} // namespace lambent::cli
