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
    bool software = true;    ///< whether a device that is itself a processor will do, if there is no other
    bool validation = false; ///< let the Khronos layer watch, where it is installed
    std::filesystem::path cache_folder; ///< for compiled shaders; empty: none are kept
};

class VulkanRenderer : public Renderer {
public:
    /// What the validation layer has said; empty is good.
    virtual std::vector<std::string> complaints() const = 0;
};

/// A renderer of `scene`, which must outlive it. Throws vulkan::NoSuchDevice where there is no Vulkan library or no device
/// that will do; Error(no_device) where it fails or has not enough memory, also when drawing.
std::unique_ptr<VulkanRenderer> make_vulkan_renderer(const scene::Scene& scene,
                                                     const VulkanOptions& options = {});

} // namespace lambent::draw
