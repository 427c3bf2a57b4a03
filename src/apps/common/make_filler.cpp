#include "apps/common/make_filler.h"

#include "base/error.h"
#include "base/text.h"

#ifdef LAMBENT_VULKAN
#include "apps/common/device_options.h"
#include "draw/vulkan/device_prefilter.h"
#include "draw/vulkan/on_hardware.h"

#include <memory>
#include <numeric>
#endif

namespace lambent::cli {
namespace {

Filler by_processor()
{
    return {environment::prefilter_faces, "cpu", {}, {}, [] { return std::nullopt; }};
}

#ifdef LAMBENT_VULKAN
using Device = std::shared_ptr<draw::DevicePrefilter>;

Filler by_device(const Device& device)
{
    return {[device](const auto& faces, const auto& report) { device->fill(faces, report); },
            "vulkan",
            device->device(),
            {},
            [device] {
                const std::vector<double>& all = device->milliseconds();
                return std::optional(std::accumulate(all.begin(), all.end(), 0.0));
            }};
}

// Once the device fails, the CPU fills the faces of that call, from the start, and of all later ones.
Filler by_device_or_processor(const Device& device, const std::function<void(const std::string&)>& warn)
{
    Filler filler = by_device(device);
    filler.given_up = std::make_shared<bool>(false);
    filler.fill = [fill = filler.fill, warn, given_up = filler.given_up](const auto& faces,
                                                                         const auto& report) {
        if (!*given_up)
            try {
                fill(faces, report);
                return;
            } catch (const Error& error) {
                if (error.failure() != Failure::no_device)
                    throw;
                warn(error.what());
                *given_up = true;
            }
        environment::prefilter_faces(faces, report);
    };
    return filler;
}
#endif

} // namespace

Filler make_filler(const BakeArguments& arguments, const std::function<void(const std::string&)>& warn)
{
    if (arguments.backend == Backend::cpu)
        return by_processor();
#ifdef LAMBENT_VULKAN
    draw::VulkanOptions options = device_options(arguments.cache);
    if (arguments.backend == Backend::vulkan)
        return by_device(std::make_shared<draw::DevicePrefilter>(options));
    options.software = false;
    const auto warn_and_go_on = [warn](const std::string& line) {
        warn(text(line, "; continuing on the CPU"));
    };
    if (const Device device = draw::on_hardware(
            [&] { return std::make_shared<draw::DevicePrefilter>(options); }, warn_and_go_on))
        return by_device_or_processor(device, warn_and_go_on);
#else
    if (arguments.backend == Backend::vulkan)
        throw Error(Failure::no_device, "--backend vulkan: this program was built without Vulkan");
#endif
    return by_processor();
}

} // namespace lambent::cli
