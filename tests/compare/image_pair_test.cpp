// Files made ready to be compared.
#include "compare/image_pair.h"
#include "image/files/image_io.h"
#include "tests/compare/test_pictures.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace lambent::compare {
namespace {

using testing::Folder;

std::string refusal(const std::string& a, const std::string& b)
{
    Warnings warnings;
    try {
        read_image_pair(a, b, warnings);
        return "";
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        return error.what();
    }
}

TEST(Picture, CodesAreSharesOfTheLargest)
{
    const Folder folder;
    const std::string a = folder.path("a.png"), b = folder.path("b.png");
    image::write_codes({1, 2, 4, 8, {0, 51, 255, 0, 1, 2, 3, 4}}, a);
    image::CodeImage deep{1, 2, 3, 16, std::vector<std::uint8_t>(12)};
    const std::uint16_t codes[6] = {0, 13107, 65535, 1, 2, 3};
    std::memcpy(deep.bytes.data(), codes, sizeof codes);
    image::write_codes(deep, b);
    Warnings warnings;
    const ImagePair pictures = read_image_pair(a, b, warnings);
    EXPECT_EQ(pictures.kind, Kind::srgb);
    ASSERT_EQ(pictures.picture.values.size(), 6u);
    EXPECT_EQ(pictures.picture.values[1], 0.2f);
    EXPECT_EQ(pictures.picture.values[2], 1.0f);
    EXPECT_EQ(pictures.picture.values[5], 3.0f / 255.0f);
    EXPECT_EQ(pictures.reference.values[1], 0.2f);
    EXPECT_EQ(pictures.reference.values[5], 3.0f / 65535.0f);
    EXPECT_TRUE(warnings.empty());
}

TEST(Picture, ValuesThatAreNotFiniteAreCountedAndTakenAsZero)
{
    const Folder folder;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    inf = std::numeric_limits<float>::infinity();
    const std::string a = folder.path("a.exr"), b = folder.path("b.exr");
    image::write_radiance({2, 1, 3, {nan, 2, 3, inf, -inf, 6}}, a);
    image::write_radiance({2, 1, 4, {1, 2, 3, nan, 4, nan, 6, 1}}, b);
    Warnings warnings;
    const ImagePair pictures = read_image_pair(a, b, warnings);
    EXPECT_EQ(pictures.kind, Kind::linear);
    EXPECT_EQ(pictures.picture.values, (std::vector<float>{0, 2, 3, 0, 0, 6}));
    EXPECT_EQ(pictures.reference.values, (std::vector<float>{1, 2, 3, 4, 0, 6}));
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_NE(warnings[0].find("a.exr: 3 values are not finite"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[1].find("b.exr: 1 value is not finite"), std::string::npos) << warnings[1];
}

TEST(Picture, OtherSizesAndKindsAreRefusedWithBothNamed)
{
    const Folder folder;
    const std::string small = folder.path("small.exr"), wide = folder.path("wide.exr"),
                      codes = folder.path("c.png");
    image::write_radiance(test::constant(2, 2, {1, 1, 1}), small);
    image::write_radiance(test::constant(4, 2, {1, 1, 1}), wide);
    image::write_codes({2, 2, 3, 8, std::vector<std::uint8_t>(12)}, codes);
    EXPECT_NE(refusal(small, wide).find("2x2"), std::string::npos);
    EXPECT_NE(refusal(small, wide).find("4x2"), std::string::npos);
    EXPECT_NE(refusal(small, codes).find("srgb"), std::string::npos);
    EXPECT_NE(refusal(small, codes).find("linear"), std::string::npos);
    EXPECT_NE(refusal(small, folder.path("missing.exr")).find("missing.exr"), std::string::npos);
    EXPECT_EQ(refusal(small, small), "");
}

TEST(Picture, ExposureAndClampStayInRange)
{
    image::RadianceImage picture{1, 1, 3, {3e38f, -1.0f, 0.5f}};
    expose(picture, 10.0f);
    EXPECT_EQ(picture.values, (std::vector<float>{std::numeric_limits<float>::max(), -10.0f, 5.0f}));
    clamp(picture, 4.0f);
    EXPECT_EQ(picture.values, (std::vector<float>{4.0f, 0.0f, 4.0f}));
}

} // namespace
} // namespace lambent::compare
