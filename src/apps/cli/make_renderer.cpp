#include "apps/cli/make_renderer.h"

#include "base/error.h"
#include "draw/cpu/cpu_renderer.h"

#ifdef LAMBENT_VULKAN
#include "apps/cli/device_options.h"
#endif

namespace lambent::cli {

std::unique_ptr<draw::Renderer> make_renderer(const RenderArguments& arguments, const scene::Scene& scene)
{
    if (arguments.backend != Backend::vulkan)
        return draw::make_cpu_renderer(scene);
#ifdef LAMBENT_VULKAN
    return draw::make_vulkan_renderer(scene, device_options(arguments.cache));
#else
    throw Error(Failure::no_device, "--backend vulkan: this program was built without Vulkan");
#endif
}

} // namespace lambent::cli
