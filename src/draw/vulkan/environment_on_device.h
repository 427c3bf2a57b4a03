// An environment in the memory of a device.
#pragma once

#include "draw/light_context.h"
#include "environment/environment.h"
#include "gpu_layout/layout.h"
#include "vulkan/commands.h"

#include <array>
#include <cstdint>
#include <optional>

namespace lambent::draw {

/// Cube maps of half floats for specular light (with mip levels) and diffuse light, and the panorama's mip chain for
/// MipLevel::report. Throws Error(no_device).
class EnvironmentOnDevice {
public:
    /// Uploads the context's environment and mip chain, if set; else textures are one black texel.
    EnvironmentOnDevice(const vulkan::Device& device, const LightContext& context);

    /// Sets the textures at their bindings.
    void offer(std::array<vulkan::Resource, gpu_layout::binding_count>& resources) const;

    /// The panorama with its texels packed as in host memory, read by address. The first call uploads it: `device` and
    /// `panorama` must be those of construction.
    const vulkan::Buffer& panorama(const vulkan::Device& device, const environment::Panorama& panorama);

private:
    vulkan::SamplerObject clamped_, around_;
    vulkan::Texture chain_, irradiance_, mips_;
    std::optional<vulkan::Buffer> panorama_;
};

/// Keeps the environment of the last picture on the device: it can take a hundred megabytes, and the next picture
/// mostly has the same one.
class KeptEnvironment {
public:
    /// The context's environment, uploaded if it is another than the last. `device` must be the same in all calls.
    EnvironmentOnDevice& of(const vulkan::Device& device, const LightContext& context);

private:
    std::optional<EnvironmentOnDevice> kept_;
    std::uint64_t number_ = 0; ///< Environment::identity of the one kept; 0: none
    bool has_mips_ = false;
};

} // namespace lambent::draw
