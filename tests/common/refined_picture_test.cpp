// How many passes a picture gets, against a picture whose error is known: e^2 = bias^2 + noise^2 / passes.
#include "apps/common/refined_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lambent::cli {
namespace {

// Its picture's one value is the number of its passes.
class CountedDrawing : public draw::Drawing {
public:
    explicit CountedDrawing(int passes) : passes_(passes) {}

    bool advance(const GoOn& go_on) override
    {
        go_on(1.0f);
        drawn_ = passes_;
        return true;
    }

    void refine(int passes) override
    {
        EXPECT_GE(passes, 1);
        passes_ += passes;
    }

    draw::Frame picture(const Check&) const override
    {
        draw::Frame frame;
        frame.radiance = {1, 1, 1, {static_cast<float>(drawn_)}};
        return frame;
    }

    draw::Frame take() override { return picture({}); }

private:
    int passes_, drawn_ = 0;
};

// Errors of one law; those whose number is in `wrong` are measured as half of what they are.
struct Law {
    double bias, noise;
    std::vector<std::uint32_t> wrong;
    std::vector<std::uint32_t>* numbers = nullptr;

    double error(int passes) const { return std::sqrt(bias * bias + noise * noise / passes); }

    std::optional<audit::Error> operator()(const image::RadianceImage& picture, std::uint32_t number) const
    {
        if (numbers)
            numbers->push_back(number);
        const double e = error(static_cast<int>(picture.values[0]));
        const bool is_wrong = std::find(wrong.begin(), wrong.end(), number) != wrong.end();
        return audit::Error{is_wrong ? 0.5 * e : e, 0.0, 1.0, 0.95, 100};
    }
};

RefinedPicture refined(const RefineLimits& limits, const Law& law, int passes = 2)
{
    return refined_picture(std::make_unique<CountedDrawing>(passes), passes, limits, law,
                           [](float done, const std::optional<audit::Error>&) {
                               EXPECT_GE(done, 0.0f);
                               EXPECT_LE(done, 1.0f);
                           });
}

TEST(RefinedPicture, IsAsGoodAsAskedWithFewMorePassesThanItNeeds)
{
    for (const double wanted : {0.2, 0.09, 0.05, 0.03, 0.02, 0.012}) {
        const Law law{0.01, 0.15, {}};
        const RefinedPicture picture = refined({wanted, {}}, law);
        const double needed = 0.15 * 0.15 / (wanted * wanted - 0.01 * 0.01);
        EXPECT_LE(law.error(picture.passes), wanted);
        EXPECT_LE(picture.passes, std::max(2.0, 1.4 * needed + 2.0)) << wanted;
        EXPECT_EQ(picture.frame.radiance.values[0], static_cast<float>(picture.passes));
        ASSERT_TRUE(picture.error);
        EXPECT_EQ(picture.error->relative_rmse, law.error(picture.passes));
    }
}

TEST(RefinedPicture, AMeasurementThatIsTooLowByChanceIsNotBelieved)
{
    std::vector<std::uint32_t> numbers;
    const Law law{0.0, 0.1, {1, 2}, &numbers};
    const RefinedPicture picture = refined({0.045, {}}, law);
    EXPECT_LE(law.error(picture.passes), 0.045);
    EXPECT_EQ(numbers.back(), 0u);
    EXPECT_EQ(numbers[0], 1u);
    EXPECT_GT(picture.passes, 2);
}

TEST(RefinedPicture, AnErrorThatIsNotReachedEndsAtTheMostPasses)
{
    const Law law{0.03, 0.1, {}};
    const RefinedPicture picture = refined({0.02, {}}, law);
    EXPECT_EQ(picture.passes, most_passes);
    EXPECT_GT(picture.error->relative_rmse, 0.02);
}

TEST(RefinedPicture, WithoutTimeItIsTheFirst)
{
    const Law law{0.0, 0.1, {}};
    EXPECT_EQ(refined({{}, 1e-9}, law, 1).passes, 1);
    EXPECT_EQ(refined({0.001, 1e-9}, law, 1).passes, 1);
}

// Passes that take no time: as many as there can be, and no measurement.
TEST(RefinedPicture, WithTimeAloneNothingIsMeasured)
{
    std::vector<std::uint32_t> numbers;
    const Law law{0.0, 0.1, {}, &numbers};
    const RefinedPicture picture = refined({{}, 1e6}, law, 1);
    EXPECT_GT(picture.passes, 1000);
    EXPECT_FALSE(picture.error);
    EXPECT_TRUE(numbers.empty());
}

TEST(RefinedPicture, WhatCannotBeMeasuredIsGoodEnough)
{
    const RefinedPicture picture = refined_picture(
        std::make_unique<CountedDrawing>(2), 2, {0.01, {}},
        [](const image::RadianceImage&, std::uint32_t) { return std::optional<audit::Error>(); },
        [](float, const std::optional<audit::Error>&) {});
    EXPECT_EQ(picture.passes, 2);
    EXPECT_FALSE(picture.error);
}

} // namespace
} // namespace lambent::cli
