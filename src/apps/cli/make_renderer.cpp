#include "apps/cli/make_renderer.h"

#include "base/error.h"
#include "draw/cpu/cpu_renderer.h"
#include "environment/environment_cache.h"

#ifdef LAMBENT_VULKAN
#include "draw/vulkan/vulkan_renderer.h"
#endif

namespace lambent::cli {

std::unique_ptr<draw::Renderer> make_renderer(const RenderArguments& arguments, const scene::Scene& scene)
{
    if (arguments.backend != Backend::vulkan)
        return draw::make_cpu_renderer(scene);
#ifdef LAMBENT_VULKAN
    draw::VulkanOptions options;
    if (arguments.cache)
        options.cache_folder = environment::user_cache_folder().value_or("");
    return draw::make_vulkan_renderer(scene, options);
#else
    throw Error(Failure::no_device, "--backend vulkan: this program was built without Vulkan");
#endif
}

} // namespace lambent::cli
