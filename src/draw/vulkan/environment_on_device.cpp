#include "draw/vulkan/environment_on_device.h"

#include "draw/vulkan/filled_buffer.h"
#include "environment/panorama/packed_texel.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>

namespace lambent::draw {
namespace {

using environment::CubeChain, environment::Panorama;
using vulkan::Buffer, vulkan::Device, vulkan::LevelBytes, vulkan::Texture, vulkan::TextureShape;

TextureShape cube_shape(const CubeChain* cube)
{
    TextureShape shape;
    shape.format = VK_FORMAT_R16G16B16A16_SFLOAT;
    shape.cube = true;
    if (cube) {
        shape.width = shape.height = static_cast<std::uint32_t>(cube->face_size(0));
        shape.levels = static_cast<std::uint32_t>(cube->levels);
    }
    return shape;
}

// The mip chain of the panorama; null if there is none.
const std::vector<Panorama>* mips_of(const LightContext& context)
{
    return context.mip_chain && !context.mip_chain->empty() ? context.mip_chain : nullptr;
}

TextureShape mips_shape(const std::vector<Panorama>* mips)
{
    TextureShape shape;
    shape.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    if (mips) {
        shape.width = static_cast<std::uint32_t>(mips->front().width);
        shape.height = static_cast<std::uint32_t>(mips->front().height);
        shape.levels = static_cast<std::uint32_t>(mips->size());
    }
    return shape;
}

// Uploads all levels of a texture. `fill` writes texels to a staging buffer that is zero before.
template <class Fill>
void upload(const Device& device, const Texture& texture, std::uint32_t texel_bytes, const Fill& fill)
{
    std::vector<LevelBytes> levels;
    VkDeviceSize bytes = 0;
    const TextureShape& shape = texture.shape();
    for (std::uint32_t level = 0; level < shape.levels; ++level) {
        levels.push_back({level, bytes});
        bytes += VkDeviceSize{texel_bytes} * std::max(shape.width >> level, 1u) *
                 std::max(shape.height >> level, 1u) * texture.layers();
    }
    const Buffer staging(device, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, vulkan::MemoryKind::upload);
    std::memset(staging.memory().data(), 0, bytes);
    fill(staging.memory().data(), levels);
    vulkan::Commands commands(device);
    commands.fill(texture, staging, levels);
    commands.run();
}

// Copies a cube without its border: devices filter across the edges of cube maps by themselves.
void fill_cube(const CubeChain& cube, std::byte* memory, const std::vector<LevelBytes>& levels)
{
    for (const LevelBytes& part : levels) {
        const int level = static_cast<int>(part.level), size = cube.face_size(level);
        tbb::parallel_for(0, 6 * size, [&](int row) {
            const std::uint16_t* from = cube.halfs() + 3 * cube.texel(level, row / size, 0, row % size);
            std::vector<std::uint16_t> texels(static_cast<std::size_t>(4 * size));
            for (std::size_t x = 0; x < static_cast<std::size_t>(size); ++x)
                std::copy_n(from + 3 * x, 3, texels.data() + 4 * x);
            const std::size_t bytes = texels.size() * sizeof(std::uint16_t);
            std::memcpy(memory + part.offset + static_cast<std::size_t>(row) * bytes, texels.data(), bytes);
        });
    }
}

void fill_mips(const std::vector<Panorama>& mips, std::byte* memory, const std::vector<LevelBytes>& levels)
{
    for (const LevelBytes& part : levels) {
        const Panorama& panorama = mips[part.level];
        tbb::parallel_for(0, panorama.height, [&](int y) {
            std::vector<float> texels(static_cast<std::size_t>(4 * panorama.width));
            for (int x = 0; x < panorama.width; ++x) {
                const environment::Rgb c = panorama.radiance(x, y);
                float* texel = texels.data() + 4 * x;
                texel[0] = c.r, texel[1] = c.g, texel[2] = c.b;
            }
            const std::size_t bytes = texels.size() * sizeof(float);
            std::memcpy(memory + part.offset + static_cast<std::size_t>(y) * bytes, texels.data(), bytes);
        });
    }
}

} // namespace

EnvironmentOnDevice::EnvironmentOnDevice(const Device& device, const LightContext& context)
    : clamped_(device, vulkan::Filter::clamped), around_(device, vulkan::Filter::around),
      chain_(device, cube_shape(context.environment ? &context.environment->chain : nullptr)),
      irradiance_(device, cube_shape(context.environment ? &context.environment->irradiance : nullptr)),
      mips_(device, mips_shape(mips_of(context)))
{
    const environment::Environment* const environment = context.environment;
    constexpr std::uint32_t halfs = 8, floats = 16;
    upload(device, chain_, halfs, [&](std::byte* memory, const std::vector<LevelBytes>& levels) {
        if (environment)
            fill_cube(environment->chain, memory, levels);
    });
    upload(device, irradiance_, halfs, [&](std::byte* memory, const std::vector<LevelBytes>& levels) {
        if (environment)
            fill_cube(environment->irradiance, memory, levels);
    });
    upload(device, mips_, floats, [&](std::byte* memory, const std::vector<LevelBytes>& levels) {
        if (const std::vector<Panorama>* const mips = mips_of(context))
            fill_mips(*mips, memory, levels);
    });
}

void EnvironmentOnDevice::offer(std::array<vulkan::Resource, gpu_layout::binding_count>& resources) const
{
    resources[gpu_layout::binding_chain] = {nullptr, &chain_, clamped_.handle()};
    resources[gpu_layout::binding_irradiance] = {nullptr, &irradiance_, clamped_.handle()};
    resources[gpu_layout::binding_mips] = {nullptr, &mips_, around_.handle()};
}

const Buffer& EnvironmentOnDevice::panorama(const Device& device, const Panorama& panorama)
{
    if (!panorama_) {
        const std::span<const std::byte> texels = std::as_bytes(std::span(panorama.texels));
        panorama_.emplace(filled_buffer(
            device, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT,
            {&texels, 1}));
    }
    return *panorama_;
}

EnvironmentOnDevice& KeptEnvironment::of(const Device& device, const LightContext& context)
{
    const std::uint64_t number = context.environment ? context.environment->identity.number() : 0;
    const bool mips = mips_of(context) != nullptr;
    if (!kept_ || number_ != number || (mips && !has_mips_)) {
        kept_.reset(); // frees its memory before the next is made
        kept_.emplace(device, context);
        number_ = number;
        has_mips_ = mips;
    }
    return *kept_;
}

} // namespace lambent::draw
