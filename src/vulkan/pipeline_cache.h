// Compiled shaders kept between runs: a driver takes long to compile and nothing to load.
#pragma once

#include "vulkan/device.h"

#include <filesystem>

namespace lambent::vulkan {

/// Pipelines compiled before, by this driver for this device. A file that is missing, broken, too large or another
/// driver's is as good as none; one that cannot be written is not written: neither is an error.
class PipelineCache {
public:
    /// An empty path: nothing is kept. The device must outlive it.
    PipelineCache(const Device& device, std::filesystem::path file);
    ~PipelineCache();
    PipelineCache(const PipelineCache&) = delete;
    PipelineCache& operator=(const PipelineCache&) = delete;

    VkPipelineCache handle() const { return cache_; }
    const Device& device() const { return device_; }

    /// Whether the file was taken.
    bool loaded() const { return loaded_; }

    /// Writes what there is now, if it has grown. Another process finds the old file or the whole new one.
    void keep() const;

private:
    const Device& device_;
    std::filesystem::path file_;
    VkPipelineCache cache_ = VK_NULL_HANDLE;
    std::size_t bytes_before_ = 0;
    bool loaded_ = false;
};

} // namespace lambent::vulkan
