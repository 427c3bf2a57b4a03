// Which device is chosen, and what is said where there is none. Needs no Vulkan.
#include "base/error.h"
#include "vulkan/instance.h"

#include <gtest/gtest.h>

namespace lambent::vulkan {
namespace {

Candidate device(const char* name, bool software, VkDeviceSize memory, const char* lacks = "")
{
    Candidate candidate;
    candidate.name = name;
    candidate.software = software;
    candidate.memory = memory;
    candidate.lacks = lacks;
    candidate.fit = candidate.lacks.empty();
    return candidate;
}

std::string refusal(const std::vector<Candidate>& devices, Choice choice)
{
    try {
        return "chose " + choose(devices, choice).name;
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::no_device);
        return error.what();
    }
}

TEST(Choice, HardwareComesFirstAndTheLargestOfIt)
{
    const std::vector<Candidate> devices = {device("pipe", true, 64), device("small", false, 2),
                                            device("large", false, 8),
                                            device("old", false, 99, "Vulkan 1.3")};
    EXPECT_EQ(choose(devices, Choice::any).name, "large");
    EXPECT_EQ(choose(devices, Choice::hardware).name, "large");
}

TEST(Choice, SoftwareOnlyWhenAskedFor)
{
    const std::vector<Candidate> devices = {device("pipe", true, 64)};
    EXPECT_EQ(choose(devices, Choice::any).name, "pipe");
    EXPECT_EQ(refusal(devices, Choice::hardware), "Vulkan: there is no suitable device; pipe is software");
}

TEST(Choice, SaysWhatEachDeviceLacks)
{
    EXPECT_EQ(refusal({}, Choice::any), "Vulkan: there is no suitable device");
    EXPECT_EQ(
        refusal({device("old", false, 1, "Vulkan 1.3"), device("copier", false, 1, "a queue")}, Choice::any),
        "Vulkan: there is no suitable device; old lacks Vulkan 1.3; copier lacks a queue");
}

TEST(Choice, FailuresOfVulkanAreOneLine)
{
    try {
        check(VK_ERROR_OUT_OF_DEVICE_MEMORY, "taking 8 MiB");
        ADD_FAILURE() << "nothing thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::no_device);
        EXPECT_STREQ(error.what(), "Vulkan: taking 8 MiB: out of device memory (-2)");
    }
    EXPECT_NO_THROW(check(VK_SUCCESS, "nothing"));
}

} // namespace
} // namespace lambent::vulkan
