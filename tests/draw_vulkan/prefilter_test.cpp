// Environments prefiltered on a device: against the processors' own, and by the bake's check against sums in double.
#include "draw/vulkan/device_prefilter.h"
#include "environment/bake/bake.h"
#include "environment/builtin/builtin.h"
#include "tests/support/process.h"
#include "tests/vulkan/compute.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::draw {
namespace {

using environment::BakedSpecular, environment::BakeLobe, environment::BakeOptions, environment::Panorama;

Panorama builtin(const char* name)
{
    return environment::make_panorama(environment::make_builtin(name, {.width = 1024}));
}

class OnDevicePrefilter : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (!test::Compute::open()) {
            ASSERT_FALSE(test::vulkan_required()) << "no Vulkan device";
            GTEST_SKIP() << "no Vulkan device";
        }
        device_ = std::make_unique<DevicePrefilter>(VulkanOptions{true, true, {}});
    }

    BakedSpecular bake(const Panorama& panorama, const BakeOptions& options)
    {
        return environment::bake_specular(panorama, options, {}, [&](const auto& faces, const auto& report) {
            device_->fill(faces, report);
        });
    }

    std::unique_ptr<DevicePrefilter> device_;
};

double relative_rmse(const image::CubeMap& a, const image::CubeMap& b)
{
    double squares = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < b.values.size(); ++i) {
        const auto x = static_cast<double>(a.values[i]), y = static_cast<double>(b.values[i]);
        squares += (x - y) * (x - y);
        sum += y;
    }
    const auto count = static_cast<double>(b.values.size());
    return std::sqrt(squares / count) / (sum / count);
}

TEST_F(OnDevicePrefilter, BakesWhatTheProcessorsBake)
{
    for (const char* name : {"kitchen", "studio"})
        for (const BakeLobe lobe : {BakeLobe::ggx, BakeLobe::phong}) {
            BakeOptions options;
            options.size = 32;
            options.lobe = lobe;
            const Panorama panorama = builtin(name);
            const BakedSpecular found = bake(panorama, options),
                                wanted = environment::bake_specular(panorama, options);
            for (std::size_t level = 1; level < found.levels.size(); ++level)
                EXPECT_LE(found.levels[level].error, options.error) << name << ", level " << level;
            const double apart = relative_rmse(found.cube, wanted.cube);
            std::printf("%s: %.2e apart\n", name, apart);
            EXPECT_LE(apart, 5e-3) << name;
        }
    EXPECT_EQ(device_->complaints(), std::vector<std::string>());
    EXPECT_GE(device_->milliseconds().size(), 4u);
}

TEST_F(OnDevicePrefilter, EvenLightStaysEven)
{
    BakeOptions options;
    options.size = 16;
    image::RadianceImage white{256, 128, 3, std::vector<float>(std::size_t{256} * 128 * 3, 2.0f)};
    const BakedSpecular baked = bake(environment::make_panorama(white), options);
    for (const float value : baked.cube.values)
        ASSERT_NEAR(value, 2.0f, 1e-4f);
}

// The same bits each time: cells are summed in an order that no race decides.
TEST_F(OnDevicePrefilter, IsTheSameEachTime)
{
    BakeOptions options;
    options.size = 16;
    const Panorama panorama = builtin("studio");
    EXPECT_EQ(bake(panorama, options).cube.values, bake(panorama, options).cube.values);
}

// A face of a size that no tile divides, with a border, as the renderer's own cubes have.
TEST_F(OnDevicePrefilter, FillsBordersAndPartsOfTiles)
{
    const Panorama panorama = builtin("kitchen");
    const environment::LightTree tree(panorama, 0.05);
    const environment::PrefilterLobe lobe = environment::ggx_lobe(0.3);
    image::CubeMap here = image::make_cube_map(10, 1), there = here;
    environment::prefilter_faces({{here, 0, environment::Prefilter(tree, lobe, 2.0), 1}});
    device_->fill({{there, 0, environment::Prefilter(tree, lobe, 2.0), 1}}, {});
    EXPECT_LE(relative_rmse(there, here), 2e-3);
    EXPECT_EQ(device_->complaints(), std::vector<std::string>());
}

} // namespace
} // namespace lambent::draw
