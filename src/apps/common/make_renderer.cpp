#include "apps/common/make_renderer.h"

#include "base/error.h"
#include "base/text.h"
#include "draw/cpu/cpu_renderer.h"
#include "draw/line_renderer.h"
#include "draw/rescued_renderer.h"

#ifdef LAMBENT_VULKAN
#include "apps/common/device_options.h"
#include "draw/vulkan/on_hardware.h"
#endif

namespace lambent::cli {
namespace {

std::unique_ptr<draw::Renderer> of_triangles(const RendererChoice& choice, const scene::Scene& scene)
{
    if (choice.backend == Backend::cpu)
        return draw::make_cpu_renderer(scene);
#ifdef LAMBENT_VULKAN
    draw::VulkanOptions options = device_options(choice.cache);
    if (choice.backend == Backend::vulkan)
        return draw::make_vulkan_renderer(scene, options);
    options.software = false;
    const auto warn = [warn = choice.warn](const std::string& line) {
        warn(text(line, "; continuing on the CPU"));
    };
    std::unique_ptr<draw::Renderer> device =
        draw::on_hardware([&] { return draw::make_vulkan_renderer(scene, options); }, warn);
    if (device)
        return draw::make_rescued_renderer(
            std::move(device), [&scene] { return draw::make_cpu_renderer(scene); }, warn);
#else
    if (choice.backend == Backend::vulkan)
        throw Error(Failure::no_device, "--backend vulkan: this program was built without Vulkan");
#endif
    return draw::make_cpu_renderer(scene);
}

} // namespace

std::unique_ptr<draw::Renderer> make_renderer(const RendererChoice& choice, const scene::Scene& scene)
{
    return draw::with_lines(of_triangles(choice, scene), scene);
}

} // namespace lambent::cli
