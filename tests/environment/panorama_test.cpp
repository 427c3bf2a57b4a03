#include "environment/panorama/panorama.h"

#include "tests/environment/test_panoramas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lambent::environment {
namespace {

using testing::integral;
using testing::Vec;

constexpr float infinite = std::numeric_limits<float>::infinity(),
                nan = std::numeric_limits<float>::quiet_NaN();

// Rows from memory, as from a file.
class MemoryReader : public image::RadianceReader {
public:
    explicit MemoryReader(image::RadianceImage image) : image_(std::move(image))
    {
        width_ = image_.width;
        height_ = image_.height;
    }

    void read_rows(int count, float* rgb) override
    {
        std::copy_n(image_.pixel(0, next_), static_cast<std::size_t>(3 * width_ * count), rgb);
        next_ += count;
    }

private:
    image::RadianceImage image_;
    int next_ = 0;
};

image::RadianceImage plain(int width, int height, float value)
{
    return {width, height, 3, std::vector<float>(static_cast<std::size_t>(3 * width * height), value)};
}

Panorama load(image::RadianceImage image, Warnings& warnings)
{
    MemoryReader reader(std::move(image));
    return load_panorama(reader, "test.hdr", warnings);
}

TEST(Panorama, KeepsSoundTexels)
{
    Warnings warnings;
    image::RadianceImage image = plain(300, 150, 0.25f);
    image.pixel(17, 33)[1] = 7.5f;
    const Panorama p = load(image, warnings);
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(p.radiance(17, 33).g, 7.5f);
    EXPECT_EQ(p.radiance(299, 149).b, 0.25f);
}

TEST(Panorama, ScalesToHoldASunFoundLate)
{
    Warnings warnings;
    image::RadianceImage image = plain(256, 128, 0.5f);
    image.pixel(3, 127)[0] = 3.0e6f; // the last row: what was packed before has to be packed again
    const Panorama p = load(image, warnings);
    EXPECT_NEAR(p.radiance(3, 127).r, 3.0e6f, 3.0e6f * 0x1p-9f);
    EXPECT_NEAR(p.radiance(3, 0).r, 0.5f, 0.5f * 0x1p-9f);
    EXPECT_TRUE(warnings.empty());
}

TEST(Panorama, MendsBrokenTexelsFromTheirNeighboursAndSaysSoOnce)
{
    Warnings warnings;
    image::RadianceImage image = plain(64, 32, 2.0f);
    image.pixel(0, 0)[0] = nan;
    image.pixel(20, 20)[2] = infinite;
    image.pixel(30, 10)[1] = 1.7e38f;
    image.pixel(40, 10)[1] = -infinite;
    for (int y = 14; y < 19; ++y) // a patch: its middle is filled from its rim
        for (int x = 50; x < 55; ++x)
            image.pixel(x, y)[0] = nan;
    const Panorama p = load(image, warnings);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            ASSERT_EQ(p.radiance(x, y).r, 2.0f) << x << ' ' << y;
    EXPECT_EQ(p.radiance(30, 10).g, 2.0f);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("29 of 2048 texels"), std::string::npos) << warnings[0];
}

TEST(Panorama, NothingButNanIsBlack)
{
    Warnings warnings;
    const Panorama p = load(plain(64, 32, nan), warnings);
    EXPECT_EQ(p.radiance(5, 5).r, 0.0f);
    EXPECT_EQ(warnings.size(), 1u);
}

TEST(Panorama, NegativeLightIsTakenAsNone)
{
    Warnings warnings;
    image::RadianceImage image = plain(64, 32, 1.0f);
    image.pixel(9, 9)[2] = -0.5f;
    const Panorama p = load(image, warnings);
    EXPECT_EQ(p.radiance(9, 9).b, 0.0f);
    EXPECT_EQ(p.radiance(9, 9).r, 1.0f);
    EXPECT_EQ(warnings.size(), 1u);
}

TEST(Panorama, WarnsOfAnOddAspectAndRefusesOneColumn)
{
    Warnings warnings;
    load(plain(64, 64, 1.0f), warnings);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("64x64"), std::string::npos);
    EXPECT_THROW(load(plain(1, 1, 1.0f), warnings), Error);
    warnings.clear();
    load(plain(2, 1, 1.0f), warnings);
    EXPECT_TRUE(warnings.empty());
}

TEST(Panorama, TexelSolidAnglesCoverTheSphere)
{
    const Panorama p = make_panorama(plain(64, 32, 1.0f));
    double sum = 0.0;
    for (int y = 0; y < 32; ++y)
        sum += 64 * texel_solid_angle(p, y);
    EXPECT_NEAR(sum, 4.0 * std::numbers::pi, 1e-12);
    EXPECT_NEAR(integral(p, [](const Vec&) { return 1.0; }), 4.0 * std::numbers::pi, 1e-9);
}

TEST(Panorama, HalvingKeepsTheLight)
{
    const Panorama p = testing::sunny_panorama(512, testing::normalized({0.3, 0.8, -0.4}));
    const auto all = [](const Vec&) { return 1.0; };
    const Panorama half = halved(p), quarter = halved(half);
    EXPECT_EQ(quarter.width, 128);
    // What is left is the rounding of RGB9E5, up to 2^-10 of a texel; most of this light is in one.
    EXPECT_NEAR(integral(half, all) / integral(p, all), 1.0, 1e-3);
    EXPECT_NEAR(integral(quarter, all) / integral(p, all), 1.0, 2e-3);
    // Nor is it moved, but within its texel.
    const Vec before = testing::moment(p), after = testing::moment(half), later = testing::moment(quarter);
    const double light = integral(p, all);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(after[axis], before[axis], 0.01 * light) << axis;
        EXPECT_NEAR(later[axis], before[axis], 0.03 * light) << axis;
    }
}

TEST(Panorama, HalvingKeepsWhereSoftLightComesFromInEachChannel)
{
    const Panorama p = testing::coloured_panorama(128), half = halved(p);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Vec before = testing::moment(p, channel), after = testing::moment(half, channel);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // The integral of (b.d) d over the sphere is 4 pi / 3 b.
            const double wanted = 4.0 / 3.0 * std::numbers::pi * testing::coloured_light[channel].first[axis];
            EXPECT_NEAR(before[axis], wanted, 1e-2) << channel << ' ' << axis;
            EXPECT_NEAR(after[axis], wanted, 1e-2) << channel << ' ' << axis;
        }
    }
}

} // namespace
} // namespace lambent::environment
