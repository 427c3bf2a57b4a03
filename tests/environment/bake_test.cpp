// Baked environments against sums over every texel in double, and against what is known in closed form.
#include "environment/bake/bake.h"
#include "environment/bake/split_sum.h"

#include "base/error.h"
#include "equations/in_double.h"
#include "tests/environment/test_panoramas.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lambent::environment {
namespace {

using testing::normalized;
using testing::Vec;

constexpr double pi = std::numbers::pi;
const Vec sun = normalized({0.5, 0.6, 0.62});

// Texels of a level, and the light that brute force finds for each.
struct Texel {
    int face, x, y;
    Vec direction;
    Vec light{};
};

// From the documentation of CubeMap alone.
Vec direction_of(int face, int x, int y, int size)
{
    const double s = (2.0 * x + 1.0) / size - 1.0, t = (2.0 * y + 1.0) / size - 1.0;
    const Vec all[6] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}};
    return normalized(all[face]);
}

std::vector<Texel> random_texels(int size, std::size_t count, double least_to_sun)
{
    std::mt19937 random(7);
    std::uniform_int_distribution<int> faces(0, 5), places(0, size - 1);
    std::vector<Texel> texels;
    while (texels.size() < count) {
        Texel texel{faces(random), places(random), places(random), {}, {}};
        texel.direction = direction_of(texel.face, texel.x, texel.y, size);
        if (testing::dot(texel.direction, sun) > least_to_sun)
            texels.push_back(texel);
    }
    return texels;
}

// All texels of a panorama, one by one.
struct Texels {
    std::vector<Vec> direction, light;
    std::vector<double> area;

    explicit Texels(const Panorama& p)
    {
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x) {
                direction.push_back(testing::texel_direction(p.width, p.height, x, y));
                light.push_back({testing::radiance_of(p, x, y, 0), testing::radiance_of(p, x, y, 1),
                                 testing::radiance_of(p, x, y, 2)});
                area.push_back(testing::texel_area(p.width, p.height, y));
            }
    }
};

// Their mean, weighted by a function of the cosine: 0 below the horizon.
template <class Weight>
void sum_all(const Texels& all, const Weight& weight, std::vector<Texel>& texels)
{
    tbb::parallel_for(std::size_t{0}, texels.size(), [&](std::size_t i) {
        Vec sum{};
        double weights = 0.0;
        for (std::size_t j = 0; j < all.area.size(); ++j) {
            const double c = testing::dot(all.direction[j], texels[i].direction);
            if (c <= 0.0)
                continue;
            const double w = weight(c) * all.area[j];
            weights += w;
            for (std::size_t k = 0; k < 3; ++k)
                sum[k] += w * all.light[j][k];
        }
        for (std::size_t k = 0; k < 3; ++k)
            texels[i].light[k] = sum[k] / weights;
    });
}

// N = V = R: D(h) N.L, where N.h is the cosine of half the angle. [Karis 2013]
auto ggx(double roughness)
{
    const double a2 = std::pow(roughness, 4);
    return [a2](double c) {
        const double NH2 = 0.5 * (1.0 + c), q = NH2 * (a2 - 1.0) + 1.0;
        return c / (q * q);
    };
}

double relative_error(const image::CubeMap& cube, int level, const std::vector<Texel>& texels,
                      double factor = 1.0)
{
    double square = 0.0, mean = 0.0;
    for (const Texel& t : texels)
        for (std::size_t k = 0; k < 3; ++k) {
            const double off =
                static_cast<double>(cube.pixel(level, t.face, t.x, t.y)[k]) - factor * t.light[k];
            square += off * off;
            mean += factor * t.light[k];
        }
    const double count = 3.0 * static_cast<double>(texels.size());
    return std::sqrt(square / count) / (mean / count);
}

const Panorama& sunny()
{
    static const Panorama panorama = testing::coloured_panorama_of(1024, [](const Vec& d) {
        if (testing::dot(d, sun) > std::cos(0.265 * pi / 180.0))
            return Vec{50000.0, 48000.0, 45000.0};
        const double stripes = 0.5 + 0.4 * std::sin(20.0 * std::atan2(d[2], d[0])) * std::hypot(d[0], d[2]);
        return d[1] > 0.0 ? Vec{0.4 * stripes, 0.6 * stripes, 1.0} : Vec{0.3, 0.2 * stripes, 0.1};
    });
    return panorama;
}

const Texels& sunny_texels()
{
    static const Texels texels(sunny());
    return texels;
}

constexpr double near_sun = 0.9659258262890683; // cos 15 degrees

TEST(Bake, IsTheSumOverAllTexelsEverywhereAndNearTheSun)
{
    const BakedSpecular baked = bake_specular(sunny(), {});
    ASSERT_EQ(baked.cube.levels, 9);
    for (const int level : {1, 3, 6}) {
        const int size = baked.cube.face_size(level);
        const double roughness = baked.levels[static_cast<std::size_t>(level)].perceptual_roughness;
        EXPECT_DOUBLE_EQ(roughness, level / 8.0);
        std::vector<Texel> anywhere = random_texels(size, 60, -2.0), near = random_texels(size, 30, near_sun);
        sum_all(sunny_texels(), ggx(roughness), anywhere);
        sum_all(sunny_texels(), ggx(roughness), near);
        const double bound = roughness < 0.35 ? 0.01 : 0.005;
        EXPECT_LT(relative_error(baked.cube, level, anywhere), bound) << "level " << level;
        EXPECT_LT(relative_error(baked.cube, level, near), bound) << "level " << level;
    }
}

TEST(Bake, SmallerErrorsCanBeAskedFor)
{
    BakeOptions options;
    options.size = 32;
    const int level = 2;
    std::vector<Texel> texels = random_texels(8, 40, -2.0);
    sum_all(sunny_texels(), ggx(level / 5.0), texels);
    options.error = 0.1;
    const BakedSpecular coarse = bake_specular(sunny(), options);
    options.error = 0.0005;
    const BakedSpecular fine = bake_specular(sunny(), options);
    EXPECT_LT(relative_error(fine.cube, level, texels), 0.0005);
    EXPECT_LT(relative_error(fine.cube, level, texels), relative_error(coarse.cube, level, texels));
    EXPECT_LT(relative_error(coarse.cube, level, texels), 0.1);
    for (const BakedLevel& l : fine.levels)
        EXPECT_LE(l.error, 0.0005);
}

// What it says of itself is found by a code of its own; here by a third, at all texels of a level.
TEST(Bake, TellsItsOwnError)
{
    BakeOptions options;
    options.size = 64;
    options.error = 0.2;
    const BakedSpecular baked = bake_specular(sunny(), options);
    const int level = 3; // 8 x 8
    std::vector<Texel> texels = random_texels(8, 100, -2.0);
    sum_all(sunny_texels(), ggx(level / 6.0), texels);
    const double real = relative_error(baked.cube, level, texels), told = baked.levels[level].error;
    EXPECT_GT(told, 0.2 * real);
    EXPECT_LT(told, 5.0 * real);
}

TEST(Bake, PhongIsThePowerOfTheCosine)
{
    BakeOptions options;
    options.size = 32;
    options.lobe = BakeLobe::phong;
    const BakedSpecular baked = bake_specular(sunny(), options);
    for (const int level : {1, 3, 5}) {
        const double roughness = baked.levels[static_cast<std::size_t>(level)].perceptual_roughness;
        const double exponent = in_double::phong_exponent(roughness * roughness);
        std::vector<Texel> texels = random_texels(baked.cube.face_size(level), 30, -2.0);
        sum_all(
            sunny_texels(), [=](double c) { return std::pow(c, exponent); }, texels);
        EXPECT_LT(relative_error(baked.cube, level, texels), 0.01) << "level " << level;
    }
}

TEST(Bake, CmgensMapping)
{
    BakeOptions options;
    options.size = 16;
    options.mapping = RoughnessMapping::cmgen;
    const BakedSpecular baked =
        bake_specular(testing::panorama_of(64, [](const Vec&) { return 1.0; }), options);
    ASSERT_EQ(baked.levels.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        // Filament: level = (levels - 1) r (2 - r).
        const double r = baked.levels[i].perceptual_roughness;
        EXPECT_NEAR(4.0 * r * (2.0 - r), static_cast<double>(i), 1e-9);
    }
}

TEST(Bake, TheWhiteFurnaceIsOneEverywhere)
{
    const Panorama white = testing::panorama_of(512, [](const Vec&) { return 1.0; });
    for (const BakeLobe lobe : {BakeLobe::ggx, BakeLobe::phong}) {
        BakeOptions options;
        options.lobe = lobe;
        options.size = 128;
        const BakedSpecular baked = bake_specular(white, options);
        for (const float value : baked.cube.values)
            ASSERT_NEAR(value, 1.0, 0.0009765625) << (lobe == BakeLobe::ggx ? "ggx" : "phong");
    }
    for (const float value : bake_irradiance(white, 16).values)
        ASSERT_NEAR(value, pi, 0.001 * pi);
}

// A turn about the vertical axis that takes texels to texels: faces follow each other.
TEST(Bake, TurnsWithThePanorama)
{
    constexpr double half_step = 1.0 / 1024.0;
    const Panorama& p = sunny();
    Panorama turned = p;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            turned.texels[static_cast<std::size_t>(y * p.width + (x + p.width / 4) % p.width)] =
                p.texels[static_cast<std::size_t>(y * p.width + x)];
    BakeOptions options;
    options.size = 64;
    const BakedSpecular a = bake_specular(p, options), b = bake_specular(turned, options);
    // +X goes to +Z, +Z to -X, -X to -Z, -Z to +X: the columns of a quarter to the right.
    const int from[4] = {0, 4, 1, 5}, to[4] = {4, 1, 5, 0};
    for (int level = 0; level < a.cube.levels; ++level) {
        double square = 0.0, mean = 0.0, count = 0.0;
        const int size = a.cube.face_size(level);
        for (int side = 0; side < 4; ++side)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x)
                    for (int k = 0; k < 3; ++k, ++count) {
                        const double was = static_cast<double>(a.cube.pixel(level, from[side], x, y)[k]),
                                     is = static_cast<double>(b.cube.pixel(level, to[side], x, y)[k]);
                        // Both are halfs, of which the nearest may be another: in the sun that is all there is.
                        square += std::pow(std::fmax(std::fabs(is - was) - was * half_step, 0.0), 2);
                        mean += was;
                    }
        EXPECT_LT(std::sqrt(square / count), 1e-4 * mean / count) << "level " << level;
    }
}

// Light is spread, not lost: the mean over all directions of a level is that of the panorama.
TEST(Bake, EveryLevelKeepsTheEnergyOfASunAlone)
{
    const Panorama p = testing::lone_sun_panorama(512, sun);
    const double flux = testing::integral(p, [](const Vec&) { return 1.0; });
    const BakedSpecular baked = bake_specular(p, {});
    for (int level = 1; level <= 6; ++level) {
        double sum = 0.0, area = 0.0;
        const int size = baked.cube.face_size(level);
        for (int face = 0; face < 6; ++face)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const double s = (2.0 * x + 1.0) / size - 1.0, t = (2.0 * y + 1.0) / size - 1.0;
                    const double texel = 4.0 / (size * size) / std::pow(1.0 + s * s + t * t, 1.5);
                    sum += texel * static_cast<double>(baked.cube.pixel(level, face, x, y)[0]);
                    area += texel;
                }
        // The narrowest lobe is sampled by texels as wide as itself: the sum over them is no better than this.
        EXPECT_NEAR(sum / area * 4.0 * pi, flux, (level == 1 ? 0.01 : 0.003) * flux) << "level " << level;
    }
}

TEST(Bake, IrradianceIsTheSumOverAllTexels)
{
    std::vector<Texel> anywhere = random_texels(32, 60, -2.0), near = random_texels(32, 30, near_sun);
    const auto cosine = [](double c) { return c; };
    sum_all(sunny_texels(), cosine, anywhere);
    sum_all(sunny_texels(), cosine, near);
    const image::CubeMap cube = bake_irradiance(sunny(), 32);
    EXPECT_LT(relative_error(cube, 0, anywhere, pi), 0.003);
    EXPECT_LT(relative_error(cube, 0, near, pi), 0.003);
}

// Light of up to second order has nine coefficients and no more.
TEST(Bake, CoefficientsOfKnownLight)
{
    const std::vector<double> c =
        irradiance_coefficients(project_to_harmonics(testing::coloured_panorama(256)));
    ASSERT_EQ(c.size(), 27u);
    for (const Vec& n : {normalized({0.3, 0.8, -0.5}), normalized({-0.9, -0.1, 0.4}), Vec{0.0, 0.0, 1.0}}) {
        // Real spherical harmonics with y up, from their definition. [Ramamoorthi and Hanrahan 2001, eq. 3]
        const double x = n[0], y = n[1], z = n[2];
        const double Y[9] = {0.282095,
                             0.488603 * y,
                             0.488603 * z,
                             0.488603 * x,
                             1.092548 * x * y,
                             1.092548 * y * z,
                             0.315392 * (3.0 * z * z - 1.0),
                             1.092548 * x * z,
                             0.546274 * (x * x - y * y)};
        for (std::size_t k = 0; k < 3; ++k) {
            double sum = 0.0;
            for (std::size_t i = 0; i < 9; ++i)
                sum += c[3 * i + k] * Y[i];
            EXPECT_NEAR(sum, testing::coloured_light[k].irradiance(n), 0.003 * sum);
        }
    }
}

TEST(Bake, SizesAndErrorsOutOfRangeAreRefused)
{
    const Panorama p = testing::panorama_of(16, [](const Vec&) { return 1.0; });
    for (const int size : {0, -1, 3, 100, 8192}) {
        BakeOptions options;
        options.size = size;
        EXPECT_THROW(bake_specular(p, options), Error) << size;
    }
    for (const double error : {0.0, 0.5, -1.0, std::nan("")}) {
        BakeOptions options;
        options.error = error;
        EXPECT_THROW(bake_specular(p, options), Error) << error;
    }
    EXPECT_THROW(bake_irradiance(p, 0), Error);
    EXPECT_THROW(bake_irradiance(p, 5000), Error);
    EXPECT_THROW(bake_split_sum_table(1), Error);
    EXPECT_THROW(bake_split_sum_table(2000), Error);
}

TEST(Bake, TinyPanoramasAndCubes)
{
    const Panorama p = testing::panorama_of(2, [](const Vec&) { return 0.25; });
    for (const int size : {1, 2, 4}) {
        BakeOptions options;
        options.size = size;
        for (const float value : bake_specular(p, options).cube.values)
            EXPECT_NEAR(value, 0.25, 0.00025);
    }
    for (const float value : bake_irradiance(p, 5).values)
        EXPECT_NEAR(value, 0.25 * pi, 0.001 * pi);
}

TEST(Bake, ReportsProgressUpToTheWhole)
{
    double last = 0.0;
    BakeOptions options;
    options.size = 32;
    bake_specular(sunny(), options, [&](double done) {
        EXPECT_GE(done, last);
        last = done;
    });
    EXPECT_GT(last, 0.99);
    EXPECT_LE(last, 1.0);
}

} // namespace
} // namespace lambent::environment
