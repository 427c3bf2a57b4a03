// Whether there is hardware to ask Vulkan for, by the names of devices. Needs no Vulkan.
#include "tests/support/process.h"
#include "vulkan/hardware.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace lambent::vulkan {
namespace {

#ifdef __linux__
TEST(Hardware, IsToldByTheNodesOfDevices)
{
    const auto with = [](const std::string& node) {
        const testing::Folder folder;
        const std::filesystem::path path = folder.path(node);
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path) << "";
        return may_have_hardware(folder.path("."));
    };
    EXPECT_TRUE(with("dri/renderD128"));
    EXPECT_TRUE(with("nvidiactl"));
    EXPECT_TRUE(with("dxg"));
    EXPECT_FALSE(with("dri/card0")); // shows pictures, no more
    EXPECT_FALSE(with("null"));
    EXPECT_FALSE(may_have_hardware("/nowhere"));
}
#endif

} // namespace
} // namespace lambent::vulkan
