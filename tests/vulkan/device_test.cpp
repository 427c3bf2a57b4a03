// Memory, textures, constants, time: on whatever device there is, watched by the validation layer.
#include "base/error.h"
#include "tests/vulkan/compute.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

namespace lambent::test {
namespace {

constexpr uint32_t levels_shader[] =
#include "levels.comp.spv.inc"
    ;

using vulkan::Buffer;
using vulkan::MemoryKind;

class OnDevice : public ::testing::Test {
protected:
    void SetUp() override
    {
        compute_ = Compute::open();
        if (!compute_) {
            ASSERT_FALSE(vulkan_required()) << "no Vulkan device";
            GTEST_SKIP() << "no Vulkan device";
        }
    }
    void TearDown() override
    {
        if (compute_) {
            EXPECT_EQ(compute_->complaints(), std::vector<std::string>());
        }
    }
    const vulkan::Device& device() const { return compute_->device(); }

    std::unique_ptr<Compute> compute_;
};

constexpr VkBufferUsageFlags copied = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;

TEST_F(OnDevice, BytesGoThereAndBack)
{
    constexpr VkDeviceSize bytes = 100'000;
    const Buffer up(device(), bytes, copied, MemoryKind::upload),
        there(device(), bytes, copied, MemoryKind::device),
        back(device(), bytes, copied, MemoryKind::readback);
    for (std::size_t i = 0; i < bytes; ++i)
        up.memory()[i] = static_cast<std::byte>(i * i >> 3);
    vulkan::Commands commands(device());
    commands.copy(up, there, bytes);
    commands.copy(there, back, bytes);
    commands.run();
    EXPECT_EQ(std::memcmp(up.memory().data(), back.memory().data(), bytes), 0);
}

TEST_F(OnDevice, BuffersMove)
{
    Buffer a(device(), 64, copied, MemoryKind::upload);
    const VkBuffer handle = a.handle();
    Buffer b = std::move(a);
    EXPECT_EQ(b.handle(), handle);
    b = Buffer(device(), 128, copied, MemoryKind::upload);
    EXPECT_EQ(b.bytes(), 128u);
}

TEST_F(OnDevice, MoreMemoryThanThereIsIsOneLine)
{
    try {
        const Buffer huge(device(), VkDeviceSize{1} << 45, copied, MemoryKind::device);
        ADD_FAILURE() << "32 TiB were there";
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::no_device);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
    compute_ = Compute::open(); // the layer may have said that it is too large: that was the point
}

// Each face of each level its own grey: face + 10 level.
TEST_F(OnDevice, CubesAreReadByDirectionAndLevel)
{
    constexpr uint32_t size = 4, levels = 3;
    vulkan::TextureShape shape;
    shape.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    shape.width = shape.height = size;
    shape.levels = levels;
    shape.cube = true;
    const vulkan::Texture cube(device(), shape);
    std::vector<float> texels;
    std::vector<vulkan::LevelBytes> parts;
    for (uint32_t level = 0; level < levels; ++level) {
        parts.push_back({level, texels.size() * sizeof(float)});
        const std::size_t values = std::size_t{4} * (size >> level) * (size >> level);
        for (uint32_t face = 0; face < 6; ++face)
            texels.insert(texels.end(), values, static_cast<float>(face + 10 * level));
    }
    const Buffer up(device(), texels.size() * sizeof(float), copied, MemoryKind::upload);
    std::memcpy(up.memory().data(), texels.data(), up.bytes());
    {
        vulkan::Commands commands(device());
        commands.fill(cube, up, parts);
        commands.run();
    }
    // Faces +X -X +Y -Y +Z -Z in their middles; level 0.5 is halfway.
    const std::array<std::array<float, 4>, 7> places = {{{1, 0, 0, 0},
                                                         {-1, 0, 0, 1},
                                                         {0, 1, 0, 2},
                                                         {0, -1, 0, 0},
                                                         {0, 0, 1, 1},
                                                         {0, 0, -1, 2},
                                                         {1, 0, 0, 0.5f}}};
    const std::array<float, 7> wanted = {0, 11, 22, 3, 14, 25, 5};
    const Buffer in(device(), sizeof places, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, MemoryKind::upload),
        out(device(), sizeof places, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, MemoryKind::readback);
    std::memcpy(in.memory().data(), places.data(), sizeof places);
    const vulkan::PipelineCache cache(device(), {});
    using vulkan::Binding;
    const vulkan::ShaderLayout layout(
        device(), {Binding::storage_buffer, Binding::sampled_cube, Binding::storage_buffer}, sizeof(float));
    const std::array<std::uint32_t, 1> twice = {2u};
    const vulkan::ComputePipeline pipeline(cache, layout, levels_shader, twice);
    const vulkan::SamplerObject sampler(device(), vulkan::Filter::clamped);
    const std::array<vulkan::Resource, 3> resources = {{{&in, nullptr, VK_NULL_HANDLE},
                                                        {nullptr, &cube, sampler.handle()},
                                                        {&out, nullptr, VK_NULL_HANDLE}}};
    const vulkan::BindingSet set(device(), layout, resources);
    const float offset = 0.5f;
    vulkan::Commands commands(device());
    commands.dispatch(pipeline, set, std::as_bytes(std::span(&offset, 1)),
                      {static_cast<uint32_t>(places.size()), 1, 1});
    commands.run();
    std::array<std::array<float, 4>, 7> found{};
    std::memcpy(found.data(), out.memory().data(), sizeof found);
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_NEAR(found[i][0], 2.0f * wanted[i] + 0.5f, 0.05f) << i;
}

TEST_F(OnDevice, WrongResourcesAreRefused)
{
    using vulkan::Binding;
    const vulkan::ShaderLayout layout(
        device(), {Binding::storage_buffer, Binding::sampled_cube, Binding::storage_buffer}, sizeof(float));
    const Buffer buffer(device(), 16, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, MemoryKind::upload);
    const std::array<vulkan::Resource, 1> few = {{{&buffer, nullptr, VK_NULL_HANDLE}}};
    EXPECT_THROW(vulkan::BindingSet(device(), layout, few), std::invalid_argument);
    const std::array<vulkan::Resource, 3> wrong = {{{&buffer, nullptr, VK_NULL_HANDLE},
                                                    {&buffer, nullptr, VK_NULL_HANDLE},
                                                    {&buffer, nullptr, VK_NULL_HANDLE}}};
    EXPECT_THROW(vulkan::BindingSet(device(), layout, wrong), std::invalid_argument);
}

TEST_F(OnDevice, PassesTakeTime)
{
    constexpr VkDeviceSize bytes = 16 << 20;
    const Buffer from(device(), bytes, copied, MemoryKind::device),
        to(device(), bytes, copied, MemoryKind::device);
    vulkan::Commands commands(device());
    commands.lap("copy");
    commands.copy(from, to, bytes);
    commands.lap("again");
    commands.copy(to, from, bytes);
    commands.run();
    ASSERT_EQ(commands.laps().size(), 2u);
    EXPECT_EQ(commands.laps()[0].first, "copy");
    for (const auto& [name, milliseconds] : commands.laps()) {
        EXPECT_GE(milliseconds, 0.0) << name;
        EXPECT_LT(milliseconds, 60'000.0) << name;
    }
    if (device().timestamp_period() > 0.0) {
        EXPECT_GT(commands.laps()[0].second + commands.laps()[1].second, 0.0);
    }
}

} // namespace
} // namespace lambent::test
