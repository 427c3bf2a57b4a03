// One lamp at a dozen places of panoramas of several sizes: poles, seam, edges and corners of the cube and between. It gives
// the same light from everywhere, that of a disc in closed form or by quadrature.
#include "environment/chain/cube_faces.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace lambent::draw {
namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr double lamp_radius = 4.0 * pi / 180.0, lamp_radiance = 100.0, around = 0.01;

std::vector<dvec3> places()
{
    const auto at = [](double elevation, double azimuth) {
        const double e = elevation * pi / 180.0, a = azimuth * pi / 180.0;
        return dvec3(std::cos(e) * std::cos(a), std::sin(e), std::cos(e) * std::sin(a));
    };
    return {at(90, 0),  at(-90, 0),   at(88, 70),  at(-87, 200),      at(75, 180), at(60, 33),
            at(0, 180), at(-20, 180), at(0, -90),  at(35.264, 45),    at(45, 90),  at(-45, 300),
            at(-63, 1), at(8, -135),  at(82, -45), at(-35.264, 135.0)};
}

double lamp_solid_angle()
{
    return 2.0 * pi * (1.0 - std::cos(lamp_radius));
}

// The disc on the panorama's texels by 8x8 points each; its light is exactly the disc's.
environment::Environment lamp_at(const dvec3& towards, int width)
{
    constexpr int fine = 8;
    const int height = width / 2;
    image::RadianceImage image{width, height, 3, {}};
    std::vector<double> covered(static_cast<std::size_t>(width * height));
    double light = 0.0;
    for (int y = 0; y < height; ++y) {
        const double texel = 2.0 * pi / width * (std::cos(pi * y / height) - std::cos(pi * (y + 1) / height));
        for (int x = 0; x < width; ++x) {
            double inside = 0.0, all = 1e-30;
            const double middle = (y + 0.5) / height * pi, turn = ((x + 0.5) / width - 0.5) * 2.0 * pi;
            const dvec3 centre(std::sin(middle) * std::cos(turn), std::cos(middle),
                               std::sin(middle) * std::sin(turn));
            const bool near = glm::dot(centre, towards) > std::cos(lamp_radius + 6.0 / width);
            for (int i = 0; near && i < fine * fine; ++i) {
                const double theta = (y + (i / fine + 0.5) / fine) / height * pi;
                const double phi = ((x + (i % fine + 0.5) / fine) / width - 0.5) * 2.0 * pi;
                const dvec3 d(std::sin(theta) * std::cos(phi), std::cos(theta),
                              std::sin(theta) * std::sin(phi));
                all += std::sin(theta);
                inside += glm::dot(d, towards) > std::cos(lamp_radius) ? std::sin(theta) : 0.0;
            }
            const double share = inside / all;
            covered[static_cast<std::size_t>(y * width + x)] = share;
            light += share * texel;
        }
    }
    const double correction = lamp_solid_angle() / light;
    for (const double share : covered)
        for (int k = 0; k < 3; ++k)
            image.values.push_back(
                static_cast<float>(around + (lamp_radiance - around) * correction * share));
    return environment::make_environment(environment::make_panorama(image));
}

struct Lamp {
    int width;
    dvec3 place;
    environment::Environment environment;
};

// All of them, made once.
const std::vector<Lamp>& lamps()
{
    static const std::vector<Lamp> all = [] {
        std::vector<Lamp> made;
        for (const int width : {256, 512, 1024})
            for (const dvec3& place : places())
                made.push_back({width, place, lamp_at(place, width)});
        return made;
    }();
    return all;
}

// A rotation that takes `from` to `to`, as its columns.
struct Turn {
    dvec3 x, y, z;

    Turn(const dvec3& from, const dvec3& to)
    {
        const auto frame = [](const dvec3& d, dvec3* axes) {
            const dvec3 other = std::fabs(d.y) < 0.7 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
            axes[0] = d;
            axes[1] = glm::normalize(glm::cross(d, other));
            axes[2] = glm::cross(d, axes[1]);
        };
        dvec3 a[3], b[3];
        frame(from, a);
        frame(to, b);
        const auto turned = [&](const dvec3& v) {
            return glm::dot(a[0], v) * b[0] + glm::dot(a[1], v) * b[1] + glm::dot(a[2], v) * b[2];
        };
        x = turned({1, 0, 0}), y = turned({0, 1, 0}), z = turned({0, 0, 1});
    }
};

void point(Camera& camera, const Turn& turn, float distance)
{
    camera.right = glm::vec3(turn.x);
    camera.up = glm::vec3(turn.y);
    camera.back = glm::vec3(turn.z);
    camera.position = distance * camera.back;
}

constexpr int view = 128; // pixels, over a right angle

struct Blur {
    double light, peak, ring, spread; // without what is around; at the middle; on a circle, and how uneven
};

Blur blur_of(const environment::Environment& environment, const dvec3& lamp, float roughness)
{
    scene::Scene nothing;
    nothing.materials.emplace_back();
    Camera camera;
    camera.vertical_fov = static_cast<float>(0.5 * pi);
    point(camera, Turn({0, 0, -1}, lamp), 0.0f);
    Settings settings = testing::small_settings(view, view, camera);
    settings.background.kind = Background::Kind::blurred;
    settings.background.roughness = roughness;
    const Frame frame = testing::draw(nothing, &environment, settings);
    const auto at = [&](double u, double v) { // -1 to 1, between pixels
        const double x = (u + 1.0) / 2.0 * view - 0.5, y = (v + 1.0) / 2.0 * view - 0.5;
        const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
        const double fx = x - x0, fy = y - y0;
        const auto p = [&](int i, int j) { return static_cast<double>(testing::pixel(frame, i, j).r); };
        return (p(x0, y0) * (1 - fx) + p(x0 + 1, y0) * fx) * (1 - fy) +
               (p(x0, y0 + 1) * (1 - fx) + p(x0 + 1, y0 + 1) * fx) * fy - around;
    };
    Blur blur{0.0, at(0, 0), 0.0, 0.0};
    for (int y = 0; y < view; ++y)
        for (int x = 0; x < view; ++x) {
            const double u = 2.0 * (x + 0.5) / view - 1.0, v = 2.0 * (y + 0.5) / view - 1.0;
            blur.light += (static_cast<double>(testing::pixel(frame, x, y).r) - around) *
                          std::pow(2.0 / view, 2) * std::pow(1.0 + u * u + v * v, -1.5);
        }
    double least = 1e30, most = 0.0;
    constexpr int points = 64;
    for (int i = 0; i < points; ++i) {
        const double a = 2.0 * pi * i / points,
                     r = std::tan(1.2 * std::pow(static_cast<double>(roughness), 2));
        const double value = at(r * std::cos(a), r * std::sin(a));
        least = std::min(least, value), most = std::max(most, value);
        blur.ring += value / points;
    }
    blur.spread = (most - least) / blur.ring;
    return blur;
}

TEST(LampPlaces, ABlurredLampIsRoundAndKeepsItsLight)
{
    const double light = lamp_solid_angle() * (lamp_radiance - around);
    for (const float roughness : {0.25f, 0.4f, 0.5f}) {
        double worst_spread = 0.0, worst_light = 0.0, least_peak = 1e30, most_peak = 0.0, least_ring = 1e30,
               most_ring = 0.0;
        for (const auto& [width, place, environment] : lamps()) {
            const Blur blur = blur_of(environment, place, roughness);
            worst_spread = std::max(worst_spread, blur.spread);
            worst_light = std::max(worst_light, std::fabs(blur.light / light - 1.0));
            least_peak = std::min(least_peak, blur.peak), most_peak = std::max(most_peak, blur.peak);
            least_ring = std::min(least_ring, blur.ring), most_ring = std::max(most_ring, blur.ring);
            std::printf("blur %.2f, %4d columns, (%5.2f %5.2f %5.2f): light %.4f, peak %.3f, ring %.3f, "
                        "spread %.2f %%\n",
                        static_cast<double>(roughness), width, place.x, place.y, place.z, blur.light / light,
                        blur.peak, blur.ring, 100.0 * blur.spread);
        }
        std::printf(
            "blur %.2f: light off by %.2f %%, peak %.3f to %.3f, circle %.3f to %.3f, uneven by %.2f %%\n",
            static_cast<double>(roughness), 100.0 * worst_light, least_peak, most_peak, least_ring, most_ring,
            100.0 * worst_spread);
        EXPECT_LT(worst_light, roughness < 0.45f ? 0.005 : 0.03); // a wide one goes beyond the picture
        // The narrow one is read at texels nearly as wide as itself.
        EXPECT_LT(worst_spread, roughness < 0.3f ? 0.08 : 0.03);
        EXPECT_LT(most_peak / least_peak, roughness < 0.3f ? 1.03 : 1.02);
        EXPECT_LT(most_ring / least_ring, 1.02);
    }
}

// GGX with height-correlated Smith masking, times the cosine, without factors of the normal and the viewer alone.
double lobe(double cos_l, double cos_v, double cos_h, double alpha)
{
    const double a2 = alpha * alpha, q = cos_h * cos_h * (a2 - 1.0) + 1.0;
    const auto root = [a2](double c) { return std::sqrt(a2 + (1.0 - a2) * c * c); };
    return cos_l / (q * q) / (cos_l * root(cos_v) + cos_v * root(cos_l));
}

constexpr int sphere = 128, step = 8;

struct Pixel {
    int x, y;
    double truth;
};

// The lamp's light as a white metal shows it, seen from +Z: its share of the lobe, by points all around and in the lamp.
std::vector<Pixel> truths(const dvec3& lamp, double alpha)
{
    struct Point {
        dvec3 d;
        double area;
    };
    std::vector<Point> all, shining;
    constexpr int rows = 192;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < 2 * rows; ++x) {
            const double theta = (y + 0.5) / rows * pi, phi = x * pi / rows;
            all.push_back(
                {{std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)},
                 std::sin(theta) * pi * pi / rows / rows});
        }
    const Turn turn({0, 0, 1}, lamp);
    constexpr int rings = 12;
    for (int i = 0; i < rings * rings; ++i) {
        const double cosine = 1.0 - (i + 0.5) / (rings * rings) * (1.0 - std::cos(lamp_radius));
        const double sine = std::sqrt(1.0 - cosine * cosine), phi = 2.0 * pi * i / std::numbers::phi;
        shining.push_back({sine * std::cos(phi) * turn.x + sine * std::sin(phi) * turn.y + cosine * turn.z,
                           lamp_solid_angle() / (rings * rings)});
    }
    std::vector<Pixel> pixels;
    for (int y = step / 2; y < sphere; y += step)
        for (int x = step / 2; x < sphere; x += step) {
            const double px = (x + 0.5) / sphere * 2.0 - 1.0, py = 1.0 - (y + 0.5) / sphere * 2.0;
            if (px * px + py * py > 0.95)
                continue;
            const dvec3 n(px, py, std::sqrt(1.0 - px * px - py * py)), v(0, 0, 1);
            const auto sum = [&](const std::vector<Point>& points) {
                double total = 0.0;
                for (const Point& p : points)
                    if (const double cos_l = glm::dot(n, p.d); cos_l > 0.0)
                        total += p.area * lobe(cos_l, n.z, glm::dot(n, glm::normalize(p.d + v)), alpha);
                return total;
            };
            pixels.push_back({x, y, around + (lamp_radiance - around) * sum(shining) / sum(all)});
        }
    return pixels;
}

struct Off {
    double error, mean; // relative RMSE; the mean over what it should be
};

Off reflected(const environment::Environment& environment, const Turn& turn, float roughness,
              const std::vector<Pixel>& pixels)
{
    scene::Scene scene;
    scene::Material material;
    material.perceptual_roughness = roughness;
    testing::add(scene, scene::make_sphere(0.5f, 128, 64), material);
    Camera camera = testing::front_camera(1.0f);
    point(camera, turn, 10.0f);
    Settings settings = testing::small_settings(sphere, sphere, camera);
    settings.edge_samples = 1;
    settings.energy_compensation = true;
    const Frame frame = testing::draw(scene, &environment, settings);
    double error = 0.0, mean = 0.0, seen = 0.0;
    for (const Pixel& p : pixels) {
        const double value = static_cast<double>(testing::pixel(frame, p.x, p.y).r);
        error += std::pow(value - p.truth, 2);
        mean += p.truth;
        seen += value;
    }
    const double count = static_cast<double>(pixels.size());
    return {std::sqrt(error / count) / (mean / count), seen / mean};
}

TEST(LampPlaces, ALampIsReflectedAlikeFromEverywhere)
{
    const dvec3 seen_at = glm::normalize(dvec3(0.4, 0.5, 0.6)); // by the camera
    struct Bound {
        float roughness;
        int columns; // at least: what is narrower shows the panorama's texels
        double error, mean;
    };
    for (const auto& [roughness, columns, error, mean] : {Bound{0.25f, 512, 0.13, 0.016},
                                                          {0.35f, 256, 0.05, 0.008},
                                                          {0.5f, 256, 0.01, 0.004},
                                                          {0.75f, 256, 0.007, 0.004}}) {
        const std::vector<Pixel> pixels = truths(seen_at, std::pow(static_cast<double>(roughness), 2));
        double worst = 0.0, least = 1e30, most = 0.0;
        for (const auto& [width, place, environment] : lamps()) {
            if (width < columns)
                continue;
            const Off off = reflected(environment, Turn(seen_at, place), roughness, pixels);
            worst = std::max(worst, off.error);
            least = std::min(least, off.mean), most = std::max(most, off.mean);
            std::printf("roughness %.2f, %4d columns, (%5.2f %5.2f %5.2f): error %.2f %%, mean %.4f\n",
                        static_cast<double>(roughness), width, place.x, place.y, place.z, 100.0 * off.error,
                        off.mean);
        }
        std::printf("roughness %.2f: error up to %.2f %%, mean %.4f to %.4f\n",
                    static_cast<double>(roughness), 100.0 * worst, least, most);
        EXPECT_LT(worst, error);
        EXPECT_GT(least, 1.0 - mean);
        EXPECT_LT(most, 1.0 + mean);
    }
}

// A disc that is all above the horizon gives pi sin^2(radius) cos(angle) times its radiance.
TEST(LampPlaces, ALampGivesItsIrradianceFromEverywhere)
{
    for (const auto& [width, place, environment] : lamps()) {
        const environment::CubeChain& map = environment.irradiance;
        const int n = map.face_size(0);
        double worst = 0.0;
        for (int i = 0; i < 6 * n * n; ++i) {
            const int face = i / (n * n), y = i / n % n, x = i % n;
            const environment::Direction d =
                environment::cube_direction(face, (2.0 * x + 1.0) / n - 1.0, (2.0 * y + 1.0) / n - 1.0);
            const double cosine = d.x * place.x + d.y * place.y + d.z * place.z;
            if (cosine < 0.25)
                continue;
            const double expected =
                pi * around + (lamp_radiance - around) * pi * std::pow(std::sin(lamp_radius), 2) * cosine;
            const double value =
                static_cast<double>(map.scale) *
                static_cast<double>(environment::from_half(map.halfs()[3 * map.texel(0, face, x, y)]));
            worst = std::max(worst, std::fabs(value / expected - 1.0));
        }
        EXPECT_LT(worst, 0.005) << width << " columns, " << place.x << ' ' << place.y << ' ' << place.z;
    }
}

} // namespace
} // namespace lambent::draw
