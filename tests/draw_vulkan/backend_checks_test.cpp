// The checks of tests/draw/backend_checks.h on a device: numbers worked out by hand, not the processor's pictures.
#include "draw/vulkan/vulkan_renderer.h"
#include "tests/draw/backend_checks.h"
#include "tests/support/process.h"
#include "tests/vulkan/compute.h"

#include <gtest/gtest.h>

namespace lambent::draw::testing {
namespace {

class OnADevice : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (!test::Compute::open()) {
            ASSERT_FALSE(test::vulkan_required()) << "no Vulkan device";
            GTEST_SKIP() << "no Vulkan device";
        }
    }

    // The same few shaders for dozens of pictures.
    static std::string shaders()
    {
        static const lambent::testing::Folder folder;
        return folder.path("");
    }

    static Frame draw(const scene::Scene& scene, const environment::Environment* environment,
                      const Settings& settings)
    {
        const std::unique_ptr<VulkanRenderer> renderer = make_vulkan_renderer(scene, {true, true, shaders()});
        Frame frame = renderer->draw(environment, settings);
        EXPECT_EQ(renderer->complaints(), std::vector<std::string>());
        return frame;
    }
};

TEST_F(OnADevice, SamplersFilterAndWrap)
{
    expect_samplers(draw);
}
TEST_F(OnADevice, SlotsDoWhatTheySay)
{
    expect_slots(draw);
}
TEST_F(OnADevice, StretchedNormals)
{
    expect_stretched_normals(draw);
}
TEST_F(OnADevice, LooksAreSpreadEvenly)
{
    expect_looks(draw);
}
TEST_F(OnADevice, BackgroundsAverage)
{
    expect_backgrounds_to_average(draw);
}
TEST_F(OnADevice, MirroredNormalMaps)
{
    expect_mirrored_normal_maps(draw);
}
TEST_F(OnADevice, AlphaModes)
{
    expect_alpha_modes(draw);
}
TEST_F(OnADevice, PanesInOrder)
{
    expect_panes_in_order(draw);
}
TEST_F(OnADevice, EdgesInsideSurfaces)
{
    expect_edges(draw);
}
TEST_F(OnADevice, SmallHighlights)
{
    expect_small_highlights(draw);
}
TEST_F(OnADevice, LampsFade)
{
    expect_lamps(draw);
}
TEST_F(OnADevice, BlursKeepLight)
{
    expect_blurs_to_keep_light(draw);
}
TEST_F(OnADevice, MergedLampsSpread)
{
    expect_merged_lamps_to_spread(draw);
}
TEST_F(OnADevice, TheReportsPipeline)
{
    expect_the_reports_pipeline(draw);
}
TEST_F(OnADevice, TheReportsBlocks)
{
    expect_the_reports_blocks(draw);
}

} // namespace
} // namespace lambent::draw::testing
