// The checks of backend_checks.h on the processor.
#include "tests/draw/backend_checks.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

namespace lambent::draw::testing {
namespace {

TEST(OnTheProcessor, SamplersFilterAndWrap)
{
    expect_samplers(draw);
}
TEST(OnTheProcessor, SlotsDoWhatTheySay)
{
    expect_slots(draw);
}
TEST(OnTheProcessor, StretchedNormals)
{
    expect_stretched_normals(draw);
}
TEST(OnTheProcessor, LooksAreSpreadEvenly)
{
    expect_looks(draw);
}
TEST(OnTheProcessor, BackgroundsAverage)
{
    expect_backgrounds_to_average(draw);
}
TEST(OnTheProcessor, MirroredNormalMaps)
{
    expect_mirrored_normal_maps(draw);
}
TEST(OnTheProcessor, AlphaModes)
{
    expect_alpha_modes(draw);
}
TEST(OnTheProcessor, PanesInOrder)
{
    expect_panes_in_order(draw);
}
TEST(OnTheProcessor, EdgesInsideSurfaces)
{
    expect_edges(draw);
}
TEST(OnTheProcessor, SmallHighlights)
{
    expect_small_highlights(draw);
}
TEST(OnTheProcessor, LampsFade)
{
    expect_lamps(draw);
}
TEST(OnTheProcessor, BlursKeepLight)
{
    expect_blurs_to_keep_light(draw);
}
TEST(OnTheProcessor, MergedLampsSpread)
{
    expect_merged_lamps_to_spread(draw);
}
TEST(OnTheProcessor, TheReportsPipeline)
{
    expect_the_reports_pipeline(draw);
}
TEST(OnTheProcessor, TheReportsBlocks)
{
    expect_the_reports_blocks(draw);
}

} // namespace
} // namespace lambent::draw::testing
