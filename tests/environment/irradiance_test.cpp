// Irradiance against sums over every texel in double, and against closed forms.
#include "environment/bake/irradiance.h"

#include "environment/chain/cube_faces.h"
#include "environment/environment.h"
#include "environment/panorama/packed_texel.h"
#include "equations/in_double.h"
#include "tests/environment/test_panoramas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace lambent::environment {
namespace {

using testing::normalized;
using testing::Vec;

// The sum over every texel of its light times the cosine; trigonometry of rows and columns is looked up.
class BruteForce {
public:
    explicit BruteForce(const Panorama& p, std::size_t channel = 0)
        : width_(static_cast<std::size_t>(p.width))
    {
        for (int x = 0; x < p.width; ++x) {
            const Vec d = testing::texel_direction(p.width, p.height, x, 0.5 * p.height - 0.5);
            cosine_.push_back(d[0]);
            sine_.push_back(d[2]);
        }
        for (int y = 0; y < p.height; ++y) {
            const double theta = (y + 0.5) / p.height * std::numbers::pi;
            rows_.push_back({std::sin(theta), std::cos(theta), testing::texel_area(p.width, p.height, y)});
            for (int x = 0; x < p.width; ++x)
                light_.push_back(testing::radiance_of(p, x, y, channel));
        }
    }

    double irradiance(const Vec& n) const
    {
        double sum = 0.0;
        for (std::size_t y = 0; y < rows_.size(); ++y) {
            const double a = n[0] * rows_[y][0], b = n[2] * rows_[y][0], c = n[1] * rows_[y][1];
            double row = 0.0;
            for (std::size_t x = 0; x < width_; ++x)
                row += light_[y * width_ + x] * std::max(a * cosine_[x] + b * sine_[x] + c, 0.0);
            sum += row * rows_[y][2];
        }
        return sum;
    }

private:
    std::size_t width_;
    std::vector<double> cosine_, sine_, light_;
    std::vector<Vec> rows_; // sine and cosine of the polar angle, solid angle of a texel
};

// The map read bilinearly, as the renderer does; an implementation of its own.
double from_map(const IrradianceMap& map, const Vec& n, std::size_t channel = 0)
{
    const FacePosition p = cube_position({n[0], n[1], n[2]});
    const int size = map.face_size(0);
    const double x = (p.s * 0.5 + 0.5) * size - 0.5, y = (p.t * 0.5 + 0.5) * size - 0.5;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    const double fx = x - x0, fy = y - y0;
    const auto at = [&](int i, int j) {
        return from_half(map.halfs()[3 * map.texel(0, p.face, i, j) + channel]) *
               static_cast<double>(map.scale);
    };
    return (at(x0, y0) * (1 - fx) + at(x0 + 1, y0) * fx) * (1 - fy) +
           (at(x0, y0 + 1) * (1 - fx) + at(x0 + 1, y0 + 1) * fx) * fy;
}

double from_harmonics(const HarmonicLight& light, const Vec& n, std::size_t channel = 0)
{
    const auto& c = light[channel];
    const in_double::Harmonics h = {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]};
    return in_double::harmonic_irradiance(h, {n[0], n[1], n[2]});
}

// 300 normals over the sphere and 100 within 15 degrees of a direction.
std::vector<Vec> normals(bool near, const Vec& direction)
{
    std::vector<Vec> list;
    const int count = near ? 100 : 300;
    const double least = near ? std::cos(15.0 * std::numbers::pi / 180.0) : -1.0;
    const in_double::mat3 frame = in_double::orthonormal_frame({direction[0], direction[1], direction[2]});
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (1.0 - least) * (i + 0.5) / count, r = std::sqrt(1.0 - z * z);
        const double phi = 2.399963229728653 * i;
        const in_double::vec3 d = frame * in_double::vec3(r * std::cos(phi), r * std::sin(phi), z);
        list.push_back({d.x, d.y, d.z});
    }
    return list;
}

struct Errors {
    double map, harmonics; // relative root mean square
};

Errors errors(const Panorama& p, const std::vector<Vec>& directions)
{
    const IrradianceMap map = make_irradiance_map(p);
    const HarmonicLight harmonics = project_to_harmonics(p);
    const BruteForce brute(p);
    double map2 = 0.0, harmonics2 = 0.0, sum = 0.0;
    for (const Vec& n : directions) {
        const double truth = brute.irradiance(n);
        map2 += std::pow(from_map(map, n) - truth, 2);
        harmonics2 += std::pow(from_harmonics(harmonics, n) - truth, 2);
        sum += truth;
    }
    const double count = static_cast<double>(directions.size()), mean = sum / count;
    return {std::sqrt(map2 / count) / mean, std::sqrt(harmonics2 / count) / mean};
}

TEST(Irradiance, OfAWhiteSphereIsPi)
{
    const Panorama p = testing::panorama_of(256, [](const Vec&) { return 1.0; });
    const IrradianceMap map = make_irradiance_map(p);
    const HarmonicLight harmonics = project_to_harmonics(p);
    for (const Vec& n : normals(false, {0, 1, 0})) {
        EXPECT_NEAR(from_map(map, n), std::numbers::pi, std::numbers::pi * 1e-3);
        EXPECT_NEAR(from_harmonics(harmonics, n), std::numbers::pi, std::numbers::pi * 1e-4);
    }
}

// Texels of a quarter of the sky and more.
TEST(Irradiance, OfAFewTexelsIsPiAsWell)
{
    for (const auto& [width, height] : {std::pair(2, 1), {3, 1}, {4, 2}, {2, 500}, {300, 2}, {16, 8}}) {
        image::RadianceImage image{width, height, 3, {}};
        image.values.assign(static_cast<std::size_t>(width * height) * 3, 1.0f);
        const Environment environment = make_environment(make_panorama(image));
        for (const Vec& n : normals(false, {0, 1, 0}))
            EXPECT_NEAR(from_map(environment.irradiance, n), std::numbers::pi, std::numbers::pi * 2e-3)
                << width << 'x' << height;
    }
}

// Light from one half of the sphere only: pi (1 + cos) / 2 at an angle from its pole.
TEST(Irradiance, OfAHalfWhiteSphereIsLinearInTheCosine)
{
    const Panorama p = testing::panorama_of(256, [](const Vec& d) { return d[1] > 0.0 ? 1.0 : 0.0; });
    const IrradianceMap map = make_irradiance_map(p);
    for (const Vec& n : normals(false, {0, 1, 0}))
        EXPECT_NEAR(from_map(map, n), std::numbers::pi * (1.0 + n[1]) / 2.0, 4e-3);
}

// Light that nine harmonics hold whole, another in each channel: by both ways, by the sum over texels and by the formula.
TEST(Irradiance, OfColouredLightOfSecondOrderIsExactInEachChannel)
{
    const Panorama p = testing::coloured_panorama(256);
    const IrradianceMap map = make_irradiance_map(p);
    const HarmonicLight harmonics = project_to_harmonics(p);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const BruteForce brute(p, channel);
        for (const Vec& n : normals(false, {0, 1, 0})) {
            const double truth = brute.irradiance(n);
            EXPECT_NEAR(truth / testing::coloured_light[channel].irradiance(n), 1.0, 1e-3);
            EXPECT_NEAR(from_harmonics(harmonics, n, channel) / truth, 1.0, 1e-3) << "channel " << channel;
            EXPECT_NEAR(from_map(map, n, channel) / truth, 1.0, 2e-3) << "channel " << channel;
        }
    }
}

// At its own texels the map is off by the cells and by the rounding to halfs, which is taken out: where two numbers
// differ by some part of a step, their roundings differ by one step as often as that part.
double error_of_cells(const Panorama& p)
{
    const IrradianceMap map = make_irradiance_map(p);
    const BruteForce brute(p);
    const int size = map.face_size(0);
    double difference = 0.0, sum = 0.0;
    for (int texel = 0; texel < 6 * size * size; texel += 3) {
        const int face = texel / (size * size), y = texel / size % size, x = texel % size;
        const Direction d = cube_direction(face, (2.0 * x + 1.0) / size - 1.0, (2.0 * y + 1.0) / size - 1.0);
        const double truth = brute.irradiance({d.x, d.y, d.z}) / static_cast<double>(map.scale);
        const double rounded = from_half(to_half(static_cast<float>(truth)));
        difference += std::fabs(from_half(map.halfs()[3 * map.texel(0, face, x, y)]) - rounded);
        sum += truth;
    }
    return difference / sum;
}

TEST(Irradiance, TheCellsAloneAreOffByLittle)
{
    const Vec sun = normalized({0.35, 0.7, -0.45});
    const double sunny = error_of_cells(testing::sunny_panorama(512, sun));
    const double coloured = error_of_cells(testing::coloured_panorama(512));
    std::printf("mean relative error of the cells: %.4f %% under a sun, %.4f %% under soft light\n",
                100.0 * sunny, 100.0 * coloured);
    // A cell across the horizon lacks what of it is above while its middle is below: of even light h^2 / 12 in all for
    // cells h high, a little less for they are narrower at the poles.
    const double most = std::pow(std::numbers::pi / 32, 2) / 12.0;
    EXPECT_LT(sunny, most);
    EXPECT_LT(coloured, most);
}

TEST(Irradiance, OfAHardSunByMapAndByHarmonics)
{
    const Vec sun = normalized({0.35, 0.7, -0.45});
    const Panorama p = testing::sunny_panorama(2048, sun);
    const Errors all = errors(p, normals(false, sun)), near = errors(p, normals(true, sun));
    std::printf("relative error    map      SH9\nsphere          %.3f %%  %.3f %%\nnear the sun    %.3f %%  "
                "%.3f %%\n",
                all.map * 100, all.harmonics * 100, near.map * 100, near.harmonics * 100);
    EXPECT_LT(all.map, 0.003);
    EXPECT_LT(near.map, 0.003);
    // Why the map is what surfaces are lit by: nine harmonics cannot hold a sun.
    EXPECT_GT(all.harmonics, 0.02);
    EXPECT_LT(all.harmonics, 0.06);
}

} // namespace
} // namespace lambent::environment
