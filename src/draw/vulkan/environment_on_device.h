// An environment where a device can look it up.
#pragma once

#include "environment/environment.h"
#include "vulkan/commands.h"

namespace lambent::draw {

/// Cubes of halfs with their mip levels, for specular and diffuse light; the panorama's own mip chain where the report's
/// levels are wanted. Throws Error(no_device).
class EnvironmentOnDevice {
public:
    /// Null: darkness, in textures of one texel. `mips`: the report's chain, or null.
    EnvironmentOnDevice(const vulkan::Device& device, const environment::Environment* environment,
                        const std::vector<environment::Panorama>* mips);

    vulkan::Resource chain() const { return {nullptr, &chain_, clamped_.handle()}; }
    vulkan::Resource irradiance() const { return {nullptr, &irradiance_, clamped_.handle()}; }
    vulkan::Resource mips() const { return {nullptr, &mips_, around_.handle()}; }

private:
    vulkan::Sampler clamped_, around_;
    vulkan::Texture chain_, irradiance_, mips_;
};

} // namespace lambent::draw
