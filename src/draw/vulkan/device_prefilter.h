// Prefiltering of environments on a Vulkan device.
#pragma once

#include "draw/vulkan/vulkan_renderer.h"
#include "environment/bake/prefilter_faces.h"
#include "vulkan/commands.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace lambent::draw {

/// Computes the same as environment::prefilter_faces, from the same trees.
class DevicePrefilter {
public:
    /// Throws as make_vulkan_renderer does.
    explicit DevicePrefilter(const VulkanOptions& options);
    ~DevicePrefilter();

    /// An environment::FillFaces. Throws Error(no_device).
    void fill(const std::vector<environment::PrefilteredFaces>& faces,
              const std::function<void(double)>& report);

    const std::string& device() const { return device_.name(); }

    /// Duration of each call to fill() on the device, milliseconds.
    const std::vector<double>& milliseconds() const { return milliseconds_; }

    /// The messages of the validation layer so far.
    std::vector<std::string> complaints() const { return instance_.validation_messages(); }

private:
    const vulkan::ComputePipeline& pipeline(bool phong);

    vulkan::Instance instance_;
    vulkan::Device device_;
    vulkan::PipelineCache cache_;
    vulkan::ShaderLayout layout_;
    std::unique_ptr<vulkan::ComputePipeline> pipelines_[2];
    std::vector<double> milliseconds_;
};

} // namespace lambent::draw
