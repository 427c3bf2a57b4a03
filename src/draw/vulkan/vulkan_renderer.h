// The backend that draws on a Vulkan device: triangles by its rasteriser, everything else by compute shaders.
#pragma once

#include "draw/renderer.h"
#include "scene/scene.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace lambent::draw {

struct VulkanOptions {
    bool software = true;               ///< allows a device that runs on the CPU, if there is no other
    bool validation = false;            ///< enables the Khronos validation layer, if it is installed
    std::filesystem::path cache_folder; ///< for compiled shaders; empty: no cache
};

class VulkanRenderer : public Renderer {
public:
    /// The messages of the validation layer so far.
    virtual std::vector<std::string> complaints() const = 0;
};

/// A renderer of `scene`, which must outlive it. Throws vulkan::NoSuchDevice if there is no Vulkan library or no
/// suitable device, and Error(no_device) if the device fails or lacks memory. Drawing throws the latter too.
std::unique_ptr<VulkanRenderer> make_vulkan_renderer(const scene::Scene& scene,
                                                     const VulkanOptions& options = {});

} // namespace lambent::draw
