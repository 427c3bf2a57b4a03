// Compiled shaders between runs, and what becomes of files that are not such.
#include "tests/support/process.h"
#include "tests/vulkan/compute.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace lambent::test {
namespace {

constexpr uint32_t squares[] =
#include "squares.comp.spv.inc"
    ;

using testing::Folder;

std::string contents(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// Compiles with the cache in a file; whether the file was taken.
bool compile(const vulkan::Device& device, const std::string& file)
{
    const vulkan::PipelineCache cache(device, file);
    const std::vector<vulkan::Binding> two(2, vulkan::Binding::storage_buffer);
    const vulkan::ShaderLayout layout(device, two, 0);
    const vulkan::ComputePipeline pipeline(cache, layout, squares);
    cache.keep();
    return cache.loaded();
}

TEST(PipelineCache, KeepsWhatWasCompiledAndNothingElse)
{
    const std::unique_ptr<Compute> compute = Compute::open();
    if (!compute) {
        ASSERT_FALSE(vulkan_required()) << "no Vulkan device";
        GTEST_SKIP() << "no Vulkan device";
    }
    const Folder folder;
    const std::string file = folder.path("made/when/needed.bin");
    EXPECT_FALSE(compile(compute->device(), file));
    const std::string kept = contents(file);
    ASSERT_GE(kept.size(), 32u);
    EXPECT_TRUE(compile(compute->device(), file));

    std::string other = kept; // of another driver: the device's number is at 12
    other[12] = static_cast<char>(other[12] ^ 1);
    for (const std::string& broken : {std::string(), std::string("short"), std::string(4096, 'x'), other}) {
        std::ofstream(file, std::ios::binary) << broken;
        EXPECT_FALSE(compile(compute->device(), file));
        EXPECT_EQ(contents(file).size(), kept.size());
    }
    EXPECT_FALSE(compile(compute->device(), "/dev/null/nowhere"));
    EXPECT_FALSE(compile(compute->device(), ""));
    EXPECT_EQ(compute->complaints(), std::vector<std::string>());
}

} // namespace
} // namespace lambent::test
