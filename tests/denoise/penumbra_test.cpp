// Noise that the filter takes away, and shadows that it leaves: against the truth, and against every blur that it could
// have taken everywhere.
#include "tests/denoise/naive_filter.h"
#include "tests/denoise/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lambent::denoise::test {
namespace {

constexpr int width = 160, height = 112;

// The noise of a level of equal pixels, relative to that of one: the root of the sum of its squared weights, which is that
// of rows times that of columns.
double remaining_noise(int level)
{
    std::vector<double> kernel = {1.0};
    for (int l = 1; l <= level; ++l) {
        const std::size_t step = std::size_t{1} << (l - 1);
        std::vector<double> wider(kernel.size() + 4 * step);
        const double binomial[] = {1 / 16.0, 4 / 16.0, 6 / 16.0, 4 / 16.0, 1 / 16.0};
        for (std::size_t i = 0; i < kernel.size(); ++i)
            for (std::size_t k = 0; k < 5; ++k)
                wider[i + k * step] += kernel[i] * binomial[k];
        kernel = wider;
    }
    double sum = 0.0;
    for (double weight : kernel)
        sum += weight * weight;
    return sum;
}

void set_exact(Picture& picture, const std::function<double(int x, int y)>& value)
{
    for (Light* light : {&picture.diffuse, &picture.specular})
        for (Plane& plane : light->exact)
            for (int y = 0; y < picture.height; ++y)
                for (int x = 0; x < picture.width; ++x)
                    plane[index_of(picture, x, y)] = static_cast<float>(value(x, y));
}

double error_of_candidate(const NaiveResult& naive, std::size_t k,
                          const std::function<double(int, int, int)>& truth)
{
    Rgb mean = filled(naive.light[0].size(), 0.0f);
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < mean[c].size(); ++i)
            mean[c][i] =
                static_cast<float>(0.5 * (naive.candidates[k][0][c][i] + naive.candidates[k][1][c][i]));
    return rms_difference(mean, truth, width);
}

// All samples within the widest blur would leave 3 % of the noise, those within the next narrower one 6 %; the choice, which
// is itself made of noisy data, must not lose more than half of that again.
TEST(Penumbra, FlatLightLosesItsNoise)
{
    for (const int count : {2, 4, 8}) {
        Picture picture = make_wall(width, height);
        std::fill(picture.count.begin(), picture.count.end(), static_cast<float>(count));
        set_exact(picture, [](int, int) { return 0.8; });
        const Share half = [](int, int) { return 0.5; };
        sample_light(picture, picture.diffuse, half, {static_cast<std::uint32_t>(count), 0.0, 0.0});
        const double noise = 0.8 * 0.5 / std::sqrt(count); // of a pixel: Bernoulli
        const double found = rms_difference(
            filter_light(picture, {}).diffuse.light, [](int, int, int) { return 0.4; }, width);
        std::printf("flat, %d samples: noise %.4f, filtered %.4f, widest blur %.4f\n", count, noise, found,
                    noise * remaining_noise(4));
        EXPECT_LT(found, 1.5 * noise * remaining_noise(3));
    }
}

// A shadow whose edge is 1 pixel wide at the top and 41 at the bottom, under light that varies.
TEST(Penumbra, IsBetterThanEveryFixedBlur)
{
    const Share visible = [](int x, int y) {
        const double edge = 1.0 + 40.0 * y / height;
        return std::clamp(0.5 + (x - 0.5 * width + 0.3 * (y - 0.5 * height)) / edge, 0.0, 1.0);
    };
    const auto exact = [](int x, int) { return 0.5 + 0.3 * std::sin(0.1 * x); };
    const auto truth = [&](int x, int y, int) { return exact(x, y) * visible(x, y); };
    for (const int count : {2, 4, 8})
        for (const double scatter : {0.0, 0.8}) {
            Picture picture = make_wall(width, height);
            std::fill(picture.count.begin(), picture.count.end(), static_cast<float>(count));
            set_exact(picture, exact);
            sample_light(picture, picture.diffuse, visible,
                         {static_cast<std::uint32_t>(count), scatter, 0.0});
            const double found = rms_difference(filter_light(picture, {}).diffuse.light, truth, width);
            const NaiveResult naive = naive_filter(picture, picture.diffuse, false, {});
            double best = 1e9;
            for (std::size_t k = 0; k < naive_candidates; ++k)
                best = std::min(best, error_of_candidate(naive, k, truth));
            const double unfiltered = error_of_candidate(naive, 0, truth);
            std::printf("penumbra, %d samples, scatter %.1f: %.4f, best fixed %.4f, unfiltered %.4f\n", count,
                        scatter, found, best, unfiltered);
            EXPECT_LT(found, 1.1 * best);
            EXPECT_LT(found, (scatter > 0.0 ? 0.2 : 0.35) * unfiltered);
        }
}

// Light of other surfaces alone: there is nothing that it could be a ratio of.
TEST(Penumbra, LightWithoutUnshadowedCounterpartIsFiltered)
{
    Picture picture = make_wall(width, height);
    const Share blocked = [](int x, int) { return x < width / 2 ? 0.9 : 0.2; };
    sample_light(picture, picture.specular, blocked, {3, 0.0, 0.0}, 2.0);
    const auto truth = [&](int x, int y, int) { return 2.0 * (1.0 - blocked(x, y)); };
    const Rgb unfiltered = picture.specular.halves[0].found;
    EXPECT_LT(rms_difference(filter_light(picture, {}).specular.light, truth, width),
              0.2 * rms_difference(unfiltered, truth, width));
}

// One sample of twenty carries all the light: the mean must stay, and the noise go.
TEST(Penumbra, SmallLampsKeepTheirLight)
{
    const Share visible = [](int x, int) { return x < width / 2 ? 0.25 : 0.75; };
    for (const int count : {4, 16}) {
        Picture picture = make_wall(width, height);
        std::fill(picture.count.begin(), picture.count.end(), static_cast<float>(count));
        set_exact(picture, [](int, int) { return 0.5; });
        sample_light(picture, picture.diffuse, visible, {5, 0.5, 20.0});
        const auto truth = [&](int x, int y, int) { return 0.5 * visible(x, y); };
        const Rgb light = filter_light(picture, {}).diffuse.light;
        double sum = 0.0;
        for (float value : light[0])
            sum += static_cast<double>(value);
        const double found = rms_difference(light, truth, width);
        const double unfiltered =
            rms_difference(picture.diffuse.halves[0].found, truth, width) / std::sqrt(2.0);
        std::printf("lamps, %d samples: %.4f, unfiltered %.4f, mean %.4f of 0.25\n", count, found, unfiltered,
                    sum / (width * height));
        EXPECT_NEAR(sum / (width * height), 0.25, 0.05 * 0.25);
        EXPECT_LT(found, 0.1 * unfiltered);
    }
}

// A dim room: a fiftieth of the unshadowed light arrives. What is called exact is 4 % too bright or too dark from column to
// column, as where the samples see a texture sharper, which is twice as much as there is. The error may hardly grow.
TEST(Penumbra, ExactLightIsNotTrustedWhereLittleArrives)
{
    double errors[2];
    for (const bool wrong : {false, true}) {
        Picture picture = make_wall(width, height);
        set_exact(picture, [](int, int) { return 0.5; });
        const Share visible = [](int x, int) { return x < width / 2 ? 0.015 : 0.025; };
        std::fill(picture.count.begin(), picture.count.end(), 32.0f);
        sample_light(picture, picture.diffuse, visible, {9, 0.5, 0.0});
        set_exact(picture, [&](int x, int) { return wrong ? 0.5 * (x % 2 != 0 ? 1.04 : 0.96) : 0.5; });
        const auto truth = [&](int x, int y, int) { return 0.5 * visible(x, y); };
        errors[wrong] = rms_difference(filter_light(picture, {}).diffuse.light, truth, width) / 0.01;
    }
    std::printf("dim room: %.4f, with exact light that is off %.4f\n", errors[0], errors[1]);
    EXPECT_LT(errors[1], 1.2 * errors[0] + 0.02);
}

// A ceiling over a floor with patches of sun: its light is ten times what would arrive without the room, few samples find
// it, and all of it stays.
TEST(Penumbra, LightBeyondTheRatiosLimitStays)
{
    Picture picture = make_wall(width, height);
    set_exact(picture, [](int, int) { return 0.05; });
    sample_light(
        picture, picture.diffuse, [](int, int) { return 0.97; }, {11, 0.5, 0.0}, 15.0);
    double sum = 0.0;
    const Rgb light = filter_light(picture, {}).diffuse.light;
    for (float value : light[0])
        sum += static_cast<double>(value) / (width * height);
    const double truth = 0.97 * 0.05 + 0.03 * 15.0;
    EXPECT_NEAR(sum / truth, 1.0, 0.05);
}

// The same samples on white and black squares: the relative error may hardly grow.
TEST(Penumbra, TexturesOfTheAlbedoStaySharp)
{
    double errors[2];
    for (const bool textured : {false, true}) {
        Picture picture = make_wall(width, height);
        const auto albedo = [&](int x, int y) {
            return textured ? (((x / 3 + y / 3) % 2) != 0 ? 0.9 : 0.1) : 0.5;
        };
        for (Plane& plane : picture.diffuse.albedo)
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    plane[index_of(picture, x, y)] = static_cast<float>(albedo(x, y));
        set_exact(picture, albedo);
        const Share visible = [](int x, int) { return 0.2 + 0.6 * x / width; };
        sample_light(picture, picture.diffuse, visible, {7, 0.3, 0.0});
        Rgb relative = filter_light(picture, {}).diffuse.light;
        for (Plane& plane : relative)
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    plane[index_of(picture, x, y)] /= static_cast<float>(albedo(x, y));
        errors[textured] = rms_difference(
            relative, [&](int x, int y, int) { return visible(x, y); }, width);
    }
    std::printf("relative error: plain %.4f, squares of .9 and .1 %.4f\n", errors[0], errors[1]);
    EXPECT_LT(errors[1], 1.3 * errors[0]);
}

} // namespace
} // namespace lambent::denoise::test
