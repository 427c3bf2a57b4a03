// Keeps compiled pipelines in a file between runs, because drivers compile slowly and load fast.
#pragma once

#include "vulkan/device.h"

#include <filesystem>

namespace lambent::vulkan {

/// Pipelines compiled by a driver for a device. A file that is missing, broken, too large or of another driver is
/// ignored, and so is a failure to write it.
class PipelineCache {
public:
    /// With an empty path nothing is read or written. The device must outlive the cache.
    PipelineCache(const Device& device, std::filesystem::path file);
    ~PipelineCache();
    PipelineCache(const PipelineCache&) = delete;
    PipelineCache& operator=(const PipelineCache&) = delete;

    VkPipelineCache handle() const { return cache_; }
    const Device& device() const { return device_; }

    /// Whether the file was used.
    bool loaded() const { return loaded_; }

    /// Writes the file if the cache has grown. Other processes see the old file or the complete new one.
    void keep() const;

private:
    const Device& device_;
    std::filesystem::path file_;
    VkPipelineCache cache_ = VK_NULL_HANDLE;
    std::size_t bytes_before_ = 0;
    bool loaded_ = false;
};

} // namespace lambent::vulkan
