// An environment where a device can look it up.
#pragma once

#include "draw/light_context.h"
#include "environment/environment.h"
#include "gpu_layout/layout.h"
#include "vulkan/commands.h"

#include <array>
#include <cstdint>
#include <optional>

namespace lambent::draw {

/// Cubes of halfs with their mip levels, for specular and diffuse light; the panorama's own mip chain where the report's
/// levels are wanted. Throws Error(no_device).
class EnvironmentOnDevice {
public:
    /// The context's, with the report's chain if that is there. Darkness in textures of one texel.
    EnvironmentOnDevice(const vulkan::Device& device, const LightContext& context);

    /// Puts what it holds where shaders look for it.
    void offer(std::array<vulkan::Resource, gpu_layout::binding_count>& resources) const;

    /// The picture itself, packed as here, to be read by address. Comes there when it is first wanted: device and panorama
    /// are those of the start.
    const vulkan::Buffer& panorama(const vulkan::Device& device, const environment::Panorama& panorama);

private:
    vulkan::SamplerObject clamped_, around_;
    vulkan::Texture chain_, irradiance_, mips_;
    std::optional<vulkan::Buffer> panorama_;
};

/// The environment of the last picture. It stays on the device: a large one has a hundred megabytes, the next picture
/// mostly the same.
class KeptEnvironment {
public:
    /// As EnvironmentOnDevice's, always with the same device.
    EnvironmentOnDevice& of(const vulkan::Device& device, const LightContext& context);

private:
    std::optional<EnvironmentOnDevice> kept_;
    std::uint64_t number_ = 0; ///< of its identity; 0: darkness
    bool has_mips_ = false;
};

} // namespace lambent::draw
