// Compute shaders without a window, for tests: storage buffers of floats in and out.
#pragma once

#include "tests/vulkan/api.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lambent::test {

struct Groups {
    uint32_t x = 1;
    uint32_t y = 1;
    uint32_t z = 1;
};

// Whether a test is to fail, not to be skipped, where there is no device: LAMBENT_REQUIRE_VULKAN=1 in the environment.
bool vulkan_required();

class Compute {
public:
    // The first device that has a queue for compute, software included; Vulkan 1.1. Null where there is no
    // Vulkan library or no such device. Where the Khronos validation layer is installed, it watches
    // everything that is done here.
    static std::unique_ptr<Compute> open();

    ~Compute();
    Compute(const Compute&) = delete;
    Compute& operator=(const Compute&) = delete;

    const std::string& device_name() const { return device_name_; }
    bool validated() const { return messenger_ != VK_NULL_HANDLE; }

    // Runs the entry point `main` and waits for it. buffers[i] is the storage buffer of set 0, binding i:
    // copied to the device before and back after. None may be empty. Throws std::runtime_error where a call
    // of Vulkan fails.
    void run(std::span<const uint32_t> spirv, std::span<std::vector<float>> buffers, Groups groups);

    // What the validation layer said so far, warnings and errors; empty is good.
    const std::vector<std::string>& complaints() const { return complaints_; }

private:
    struct Buffer {
        VkBuffer buffer;
        VkDeviceMemory memory;
        VkDeviceSize bytes;
    };
    // Destroyers of what one run makes, called in reverse order.
    struct Undo {
        std::vector<std::function<void()>> steps;
        ~Undo();
    };

    Compute() = default;
    bool make_instance();
    void watch();
    bool make_device();
    uint32_t shared_memory_type(uint32_t allowed) const;
    Buffer make_buffer(size_t floats, Undo& undo) const;
    void copy_in(const Buffer& buffer, const std::vector<float>& from) const;
    void copy_out(const Buffer& buffer, std::vector<float>& to) const;
    VkDescriptorSetLayout make_set_layout(uint32_t buffers, Undo& undo) const;
    VkDescriptorSet make_set(VkDescriptorSetLayout layout, const std::vector<Buffer>& buffers,
                             Undo& undo) const;
    VkPipeline make_pipeline(std::span<const uint32_t> spirv, VkPipelineLayout layout, Undo& undo) const;
    VkCommandBuffer begin_commands(Undo& undo) const;
    void submit_and_wait(VkCommandBuffer commands) const;

    Api api_;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    uint32_t family_ = 0;
    std::string device_name_;
    std::vector<std::string> complaints_;
};

} // namespace lambent::test
