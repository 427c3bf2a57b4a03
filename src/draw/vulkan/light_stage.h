// The lighting passes of src/shading on a device, over fragments that somebody else has found.
#pragma once

#include "draw/cpu/fragments.h"
#include "draw/cpu/light_kernel.h"
#include "draw/vulkan/environment_on_device.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lambent::draw {

/// What light_directly, light_ambiently and light_specularly do, by compute shaders. One picture's worth of context.
class LightStage {
public:
    /// Everything referred to must outlive it. Throws Error(no_device).
    LightStage(const vulkan::Device& device, const vulkan::PipelineCache& cache, const LightContext& context,
               std::span<const LightSource> lights);
    ~LightStage();

    /// Fills direct_*, and with an environment irradiance_*, ambient_* and reflected_*, of all fragments; sizes above 0.
    void light(Fragments& fragments);

    /// Passes of the last call and the milliseconds that each took on the device.
    const std::vector<std::pair<std::string, double>>& laps() const { return laps_; }

private:
    struct Pass;
    struct Room; ///< buffers for a number of fragments

    void make_passes(const vulkan::PipelineCache& cache);
    void fill_tables(std::span<const LightSource> lights);
    void make_room(std::size_t count);
    vulkan::Buffer filled(std::span<const std::byte> bytes) const;

    const vulkan::Device& device_;
    const LightContext& context_;
    EnvironmentOnDevice environment_;
    std::optional<vulkan::Buffer> lights_, samples_, lamps_, albedo_;
    std::vector<std::unique_ptr<Pass>> passes_;
    std::unique_ptr<Room> room_;
    int light_count_ = 0;
    std::vector<std::pair<std::string, double>> laps_;
};

} // namespace lambent::draw
