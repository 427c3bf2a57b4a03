#include "bench/specular/yardstick.h"

#include "draw/sample_tables.h"
#include "environment/chain/cube_faces.h"
#include "environment/panorama/packed_texel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lambent::bench {
namespace {

using Vec = std::array<double, 3>;

double dot(const Vec& a, const Vec& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vec scaled(const Vec& a, double s)
{
    return {a[0] * s, a[1] * s, a[2] * s};
}

Vec normalized(const Vec& a)
{
    return scaled(a, 1.0 / std::sqrt(dot(a, a)));
}

Vec cross(const Vec& a, const Vec& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void copy(const Vec& from, float* to)
{
    for (std::size_t k = 0; k < 3; ++k)
        to[k] = static_cast<float>(from[k]);
}

// One level of a cube map: six faces of n x n colours.
struct Level {
    int n;
    std::vector<std::array<float, 3>> colors;

    const std::array<float, 3>& at(int face, int x, int y) const
    {
        return colors[static_cast<std::size_t>((face * n + y) * n + x)];
    }
};

Level finest_level(int n)
{
    Level level{n, {}};
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const auto d =
                    environment::cube_direction(face, (2.0 * x + 1.0) / n - 1.0, (2.0 * y + 1.0) / n - 1.0);
                const float direction[3] = {static_cast<float>(d.x), static_cast<float>(d.y),
                                            static_cast<float>(d.z)};
                std::array<float, 3> rgb{};
                yardstick_radiance(direction, rgb.data());
                level.colors.push_back(rgb);
            }
    return level;
}

Level half_level(const Level& from)
{
    Level to{from.n / 2, {}};
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < to.n; ++y)
            for (int x = 0; x < to.n; ++x) {
                std::array<float, 3> sum{};
                for (int k = 0; k < 4; ++k)
                    for (std::size_t c = 0; c < 3; ++c)
                        sum[c] += 0.25f * from.at(face, 2 * x + k % 2, 2 * y + k / 2)[c];
                to.colors.push_back(sum);
            }
    return to;
}

// A texel of a face, or where that lies outside, of the face beyond.
const std::array<float, 3>& texel_or_neighbour(const Level& level, int face, int x, int y)
{
    const int n = level.n;
    if (x >= 0 && y >= 0 && x < n && y < n)
        return level.at(face, x, y);
    const auto p = environment::cube_position(
        environment::cube_direction(face, (2.0 * x + 1.0) / n - 1.0, (2.0 * y + 1.0) / n - 1.0));
    const auto index = [n](double s) { return std::clamp(static_cast<int>((s * 0.5 + 0.5) * n), 0, n - 1); };
    return level.at(p.face, index(p.s), index(p.t));
}

void pack(const Level& level, YardstickCube& cube)
{
    std::size_t out = 24 * static_cast<std::size_t>(level.n) * static_cast<std::size_t>(level.n);
    for (int face = 0; face < 6; ++face)
        for (int y = -1; y <= level.n; ++y)
            for (int x = -1; x <= level.n; ++x) {
                const auto& c = texel_or_neighbour(level, face, x, y);
                cube.texels[out++] = static_cast<std::int32_t>(environment::pack_rgb9e5(c[0], c[1], c[2]));
            }
}

YardstickCube pack_chain(Level level)
{
    YardstickCube cube;
    while ((1 << cube.log2_size) < level.n)
        ++cube.log2_size;
    const std::size_t n = static_cast<std::size_t>(level.n);
    cube.texels.resize(24 * n * n + 6 * (n + 2) * (n + 2) + 16);
    for (pack(level, cube); level.n > 1; pack(level, cube))
        level = half_level(level);
    return cube;
}

} // namespace

void yardstick_radiance(const float direction[3], float rgb[3])
{
    const Vec d = {direction[0], direction[1], direction[2]};
    const double up = std::max(0.0, d[1]);
    Vec c = {0.25 * (1 - 0.6 * up) + 0.6 * std::exp(-8 * up), 0.45 * (1 - 0.6 * up) + 0.5 * std::exp(-8 * up),
             0.9 * (1 - 0.6 * up) + 0.4 * std::exp(-8 * up)};
    if (d[1] <= 0)
        c = scaled({0.22, 0.2, 0.17}, 1 + 0.5 * std::sin(12 * d[0]) * std::sin(12 * d[2]));
    const auto lamp = [&](const Vec& towards, double sharpness, const Vec& color) {
        const double light = std::exp(sharpness * (dot(d, normalized(towards)) - 1));
        for (std::size_t k = 0; k < 3; ++k)
            c[k] += color[k] * light;
    };
    lamp({0.6, 0.7, 0.5}, 900, {300, 270, 220});
    lamp({-0.8, 0.35, 0.3}, 60, {8, 9, 12});
    lamp({0.2, 0.2, -1}, 25, {4, 2.5, 1.5});
    copy(c, rgb);
}

YardstickScene make_yardstick_scene()
{
    YardstickScene scene{};
    const Vec eye = {0, 1.15, 4.2}, forward = normalized({0, 0.55 - 1.15, -4.2});
    const Vec right = normalized(cross(forward, {0, 1, 0})), up = cross(right, forward);
    const double extent = std::tan(22.5 * std::numbers::pi / 180);
    copy(eye, scene.eye);
    copy(forward, scene.forward);
    copy(scaled(right, extent * yardstick_width / yardstick_height), scene.right);
    copy(scaled(up, extent), scene.up);
    for (int i = 0; i < yardstick_samples; ++i) {
        const double phi = 2 * std::numbers::pi * (i + 0.5) / yardstick_samples;
        const double xi2 = draw::radical_inverse(static_cast<unsigned>(i)) + 0.5 / 64;
        copy({std::cos(phi), std::sin(phi), std::log2(xi2)}, scene.points[i]);
    }
    constexpr int size = 512;
    scene.environment = pack_chain(finest_level(size));
    scene.irradiance = pack_chain(finest_level(16));
    scene.base_level = static_cast<float>(0.5 * std::log2(6.0 * size * size / yardstick_samples));
    return scene;
}

std::vector<YardstickSurface> yardstick_surfaces(const YardstickScene& scene)
{
    std::vector<YardstickSurface> surfaces;
    const Vec eye = {scene.eye[0], scene.eye[1], scene.eye[2]};
    for (int y = 0; y < yardstick_height; ++y)
        for (int x = 0; x < yardstick_width; ++x) {
            const double across = (x + 0.5) * 2 / yardstick_width - 1,
                         down = 1 - (y + 0.5) * 2 / yardstick_height;
            Vec ray{};
            for (std::size_t k = 0; k < 3; ++k)
                ray[k] = scene.forward[k] + across * scene.right[k] + down * scene.up[k];
            ray = normalized(ray);
            const double b = dot(eye, ray), discriminant = b * b - dot(eye, eye) + 1;
            const bool floor = ray[1] < 0 && (-1 - eye[1]) / ray[1] < 40;
            if (discriminant <= 0 && !floor)
                continue;
            Vec n = {0, 1, 0};
            for (std::size_t k = 0; k < 3 && discriminant > 0; ++k)
                n[k] = eye[k] + (-b - std::sqrt(discriminant)) * ray[k];
            YardstickSurface s{};
            copy(n, s.normal);
            copy(scaled(ray, -1), s.view);
            s.exponent = discriminant > 0 ? static_cast<float>(std::exp2(6 + 4 * n[1])) : 64.0f;
            copy(discriminant > 0 ? Vec{1, 0.77, 0.34} : Vec{0.04, 0.04, 0.04}, s.specular);
            surfaces.push_back(s);
        }
    return surfaces;
}

} // namespace lambent::bench
