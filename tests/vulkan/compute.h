// Compute shaders for tests: storage buffers of floats in and out, by src/vulkan.
#pragma once

#include "vulkan/commands.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lambent::test {

using vulkan::Groups;

// Whether a test is to fail, not to be skipped, where there is no device: LAMBENT_REQUIRE_VULKAN=1 in the environment.
bool vulkan_required();

class Compute {
public:
    // Any device, hardware first. Null where there is no Vulkan library or no device that will do. Where the Khronos
    // validation layer is installed, it watches everything that is done here.
    static std::unique_ptr<Compute> open();

    const vulkan::Device& device() const { return device_; }
    const std::string& device_name() const { return device_.name(); }
    bool validated() const { return instance_.validated(); }

    // Runs the entry point `main` and waits for it. buffers[i] is the storage buffer of set 0, binding i:
    // copied to the device before and back after. None may be empty. Throws Error where a call of Vulkan fails.
    void run(std::span<const uint32_t> spirv, std::span<std::vector<float>> buffers, Groups groups);

    // What the validation layer said so far, warnings and errors; empty is good.
    std::vector<std::string> complaints() const { return instance_.validation_messages(); }

private:
    Compute();

    vulkan::Instance instance_;
    vulkan::Device device_;
    vulkan::PipelineCache cache_;
};

} // namespace lambent::test
