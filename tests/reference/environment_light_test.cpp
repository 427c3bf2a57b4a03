// The environment as a light: what it shines, where it is drawn, and how likely.
#include "reference/environment_light.h"

#include "image/panorama_rows.h"
#include "tests/reference/traced.h"
#include "tests/support/chi_square.h"

#include <algorithm>
#include <random>

namespace lambent::reference {
namespace {

using namespace testing;

image::RadianceImage picture(int width, int height, const std::function<double(int, int)>& light)
{
    image::RadianceImage image{width, height, 3, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const double tint : {1.0, 0.5, 2.0})
                image.values.push_back(static_cast<float>(tint * light(x, y)));
    return image;
}

// Uneven, with black parts and a bright spot.
image::RadianceImage uneven(int width, int height)
{
    return picture(width, height, [=](int x, int y) {
        if (x == width / 3 && y == height / 4)
            return 500.0;
        return x < width / 8 ? 0.0 : 1.0 + std::sin(0.3 * x) * std::cos(0.2 * y);
    });
}

image::RadianceImage lone_texel(int width, int height, int column, int row)
{
    return picture(width, height, [=](int x, int y) { return x == column && y == row ? 1e5 : 0.0; });
}

glm::dvec3 direction_of(double u, double v)
{
    const double phi = (u - 0.5) * 2.0 * pi, theta = v * pi;
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

glm::dvec3 turned(const glm::dvec3& d, double angle) // counter-clockwise seen from above
{
    return {d.x * std::cos(angle) + d.z * std::sin(angle), d.y,
            d.z * std::cos(angle) - d.x * std::sin(angle)};
}

double row_angle(int y, int rows, int columns)
{
    return 2.0 * pi / columns * (std::cos(pi * y / rows) - std::cos(pi * (y + 1) / rows));
}

// Over boxes of the panorama, each within one cell.
double integral_of_density(const EnvironmentLight& light, int columns, int rows, double rotation)
{
    double sum = 0.0;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            sum += light.density(turned(direction_of((x + 0.5) / columns, (y + 0.5) / rows), rotation)) *
                   row_angle(y, rows, columns);
    return sum;
}

TEST(ReferenceEnvironmentLight, DensityIntegratesToOne)
{
    for (const double rotation : {0.0, 1.234}) {
        const image::RadianceImage small = uneven(64, 32), odd = uneven(1000, 333), least = uneven(2, 1);
        EXPECT_NEAR(integral_of_density({small, rotation}, 192, 96, rotation), 1.0, 1e-9);
        EXPECT_NEAR(integral_of_density({odd, rotation}, 1000, 333, rotation), 1.0, 1e-9);
        EXPECT_NEAR(integral_of_density({least, rotation}, 6, 30, rotation), 1.0, 1e-9);
    }
    const image::RadianceImage large = lone_texel(4096, 2048, 1001, 703), between = uneven(3000, 1500);
    EXPECT_NEAR(integral_of_density({large, 0.0}, 2048, 1024, 0.0), 1.0, 1e-9);
    EXPECT_NEAR(integral_of_density({between, 0.0}, 2048, 1024, 0.0), 1.0, 1e-9);
}

// Boxes of which a whole number make a cell, or the other way round.
void expect_drawn_by_density(const image::RadianceImage& image, int columns, int rows, double rotation)
{
    const EnvironmentLight light(image, rotation);
    std::vector<double> probabilities;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            double sum = 0.0; // 20 x 37 divides what the tests use
            for (int j = 0; j < 37; ++j)
                for (int i = 0; i < 20; ++i)
                    sum += light.density(turned(
                               direction_of((x + (i + 0.5) / 20) / columns, (y + (j + 0.5) / 37) / rows),
                               rotation)) *
                           row_angle(37 * y + j, 37 * rows, 20 * columns);
            probabilities.push_back(sum);
        }
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform;
    const auto draw = [&] {
        const double first = uniform(random);
        const EnvironmentLight::Drawn d = light.draw({first, uniform(random)});
        const glm::dvec2 place = light.place_of(d.direction);
        EXPECT_NEAR(place.x, d.place.x, 1e-7);
        EXPECT_NEAR(place.y, d.place.y, 1e-7);
        EXPECT_NEAR(light.density_at(d.place), d.density, 1e-9 * d.density);
        const auto width = static_cast<std::size_t>(columns), height = static_cast<std::size_t>(rows);
        return test::part_of(place.y, height) * width + test::part_of(place.x, width);
    };
    EXPECT_TRUE(test::follows(test::count(200000, probabilities.size(), draw), probabilities));
}

TEST(ReferenceEnvironmentLight, DrawsByItsDensity)
{
    expect_drawn_by_density(uneven(16, 8), 64, 32, 0.0);
    expect_drawn_by_density(uneven(64, 32), 64, 32, 0.8);
    expect_drawn_by_density(uneven(1000, 333), 50, 9, 0.0);
}

// What the light of all draws is worth is the integral of what is read.
TEST(ReferenceEnvironmentLight, DrawsTellTheWholeLight)
{
    for (const image::RadianceImage& image :
         {uneven(64, 32), uneven(1000, 333), lone_texel(4096, 2048, 0, 500), lone_texel(64, 32, 5, 0),
          lone_texel(64, 32, 63, 31), lone_texel(9, 5, 3, 1), lone_texel(2, 1, 1, 0)}) {
        const EnvironmentLight light(image, 0.3);
        // Each texel gives its radiance times its solid angle, in the first and last row too.
        double expected = 0.0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                expected +=
                    static_cast<double>(image.pixel(x, y)[0]) * row_angle(y, image.height, image.width);
        std::mt19937_64 random(9);
        std::uniform_real_distribution<double> uniform;
        constexpr int count = 200000;
        double mean = 0.0, squares = 0.0;
        for (int i = 0; i < count; ++i) {
            const double first = uniform(random);
            const EnvironmentLight::Drawn d = light.draw({first, uniform(random)});
            const double worth = light.radiance(d.direction).x / d.density;
            mean += worth / count;
            squares += worth * worth / count;
        }
        const double deviation = std::sqrt((squares - mean * mean) / count);
        EXPECT_NEAR(mean, expected, deviations * deviation + 1e-6 * expected);
        EXPECT_LT(deviation, 0.01 * expected);
    }
}

TEST(ReferenceEnvironmentLight, NoLightIsWhereNothingIsDrawn)
{
    struct Case {
        int width, height, column, row;
    };
    for (const Case& c : {Case{4096, 2048, 1001, 703}, Case{4096, 2048, 0, 0}, Case{4096, 2048, 4095, 2047},
                          Case{3000, 1500, 1234, 777}, Case{1000, 333, 500, 100}, Case{5000, 333, 0, 332}}) {
        const image::RadianceImage image = lone_texel(c.width, c.height, c.column, c.row);
        const EnvironmentLight light(image, 0.0);
        int lit = 0;
        for (int j = -20; j <= 20; ++j)
            for (int i = -20; i <= 20; ++i) {
                const double u = (c.column + 0.5 + 0.0749 * i) / c.width,
                             v = (c.row + 0.5 + 0.0749 * j) / c.height;
                const glm::dvec3 d = direction_of(u, std::clamp(v, 0.0, 1.0));
                if (light.radiance(d).x > 0.0) {
                    ++lit;
                    EXPECT_GT(light.density(d), 0.0) << c.width << ' ' << i << ' ' << j;
                }
            }
        EXPECT_GT(lit, 300);
    }
}

TEST(ReferenceEnvironmentLight, RadianceIsBilinear)
{
    const int width = 8, height = 4;
    const image::RadianceImage image =
        picture(width, height, [](int x, int y) { return 1.0 + x * x + 10.0 * y; });
    const auto texel = [&](int x, int y) {
        const float* p = image.pixel((x + width) % width, std::clamp(y, 0, height - 1));
        return glm::dvec3(p[0], p[1], p[2]);
    };
    std::vector<double> rows; // where they lie, in rows
    for (const double angle : image::row_angles(height))
        rows.push_back(angle / pi * height);
    for (const double rotation : {0.0, 0.9, -2.0}) {
        const EnvironmentLight light(image, rotation);
        const auto at = [&](double x, double y) {
            return light.radiance(turned(direction_of(x / width, y / height), rotation));
        };
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const double row = rows[static_cast<std::size_t>(y)];
                EXPECT_LT(glm::length(at(x + 0.5, row) - texel(x, y)), 1e-6);
                EXPECT_LT(glm::length(at(x + 0.75, row) - 0.75 * texel(x, y) - 0.25 * texel(x + 1, y)), 1e-6);
                EXPECT_LT(glm::length(at(x + 1e-9, row) - 0.5 * (texel(x, y) + texel(x - 1, y))), 1e-5);
                // From the last row to itself, half a turn away; the pole is half way.
                const int pole = y < 2 ? 0 : height - 1;
                const double opposite = 0.5 - 0.5 * 0.1 / rows.front();
                EXPECT_LT(glm::length(at(x + 0.5, y < 2 ? 0.1 : height - 0.1) -
                                      (1.0 - opposite) * texel(x, pole) -
                                      opposite * texel(x + width / 2, pole)),
                          1e-6);
                if (y + 1 == height)
                    continue;
                const double between = 0.75 * row + 0.25 * rows[static_cast<std::size_t>(y) + 1];
                EXPECT_LT(glm::length(at(x + 0.5, between) - 0.75 * texel(x, y) - 0.25 * texel(x, y + 1)),
                          1e-6);
            }
        const double up = light.radiance({0.0, 1.0, 0.0}).x, down = light.radiance({0.0, -1.0, 0.0}).x;
        EXPECT_TRUE(up >= 1.0 && up <= 50.0) << up;
        EXPECT_TRUE(down >= 31.0 && down <= 80.0) << down;
    }
}

// Light that grows linearly in a horizontal direction does so across the poles, where a picture that ended there would have
// steps as large as its first row is from the pole.
TEST(ReferenceEnvironmentLight, GoesOnAcrossThePoles)
{
    const int width = 256, height = 16;
    const std::vector<double> angles = image::row_angles(height);
    const auto expected = [](const glm::dvec3& d) { return 2.0 + 0.8 * d.x - 0.6 * d.z; };
    const image::RadianceImage image = picture(width, height, [&](int x, int y) {
        return expected(direction_of((x + 0.5) / width, angles[static_cast<std::size_t>(y)] / pi));
    });
    const EnvironmentLight light(image, 0.0);
    for (int i = 0; i <= 40; ++i)
        for (int j = 0; j < 100; ++j) {
            const double polar = i / 40.0 * angles.front();
            for (const double angle : {polar, pi - polar}) {
                const glm::dvec3 d = direction_of((j + 0.3) / 100, angle / pi);
                // Along a meridian a sine is linear but for its third order, across columns but for its second.
                EXPECT_NEAR(light.radiance(d).x, expected(d), 0.01 * angles.front()) << i << ", " << j;
            }
        }
}

TEST(ReferenceEnvironmentLight, ABlackOneIsNeverDrawn)
{
    const image::RadianceImage black = picture(16, 8, [](int, int) { return 0.0; });
    const EnvironmentLight light(black, 0.0);
    EXPECT_EQ(light.draw({0.3, 0.7}).density, 0.0);
    EXPECT_EQ(light.density({0.0, 0.0, 1.0}), 0.0);
    EXPECT_EQ(light.radiance({0.0, 0.0, 1.0}), glm::dvec3(0.0));
}

} // namespace
} // namespace lambent::reference
