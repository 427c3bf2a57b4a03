#include "environment/peaks.h"

#include "environment/cube_faces.h"
#include "equations/in_double.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace lambent::environment {
namespace {

constexpr double least_over_mean = 16.0;
constexpr double most_of_all = 1.0 / 200.0;

double largest_channel(const Rgb& c)
{
    return std::max(c.r, std::max(c.g, c.b));
}

double mean_radiance(const Panorama& panorama)
{
    const double sum = tbb::parallel_reduce(
        tbb::blocked_range<int>(0, panorama.height), 0.0,
        [&](const tbb::blocked_range<int>& rows, double total) {
            for (int y = rows.begin(); y < rows.end(); ++y) {
                double row = 0.0;
                for (int x = 0; x < panorama.width; ++x)
                    row += largest_channel(panorama.radiance(x, y));
                total += row * texel_solid_angle(panorama, y);
            }
            return total;
        },
        [](double a, double b) { return a + b; });
    return sum / (4.0 * std::numbers::pi);
}

std::size_t texels_above(const Panorama& panorama, double limit)
{
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, panorama.texels.size(), 1 << 14), std::size_t{0},
        [&](const tbb::blocked_range<std::size_t>& range, std::size_t count) {
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                count += largest_channel(unpack_rgb9e5(panorama.texels[i])) * panorama.scale > limit;
            return count;
        },
        [](std::size_t a, std::size_t b) { return a + b; });
}

Peak cut_off(const Panorama& panorama, int x, int y, double limit)
{
    const Rgb c = panorama.radiance(x, y);
    const double excess = (1.0 - limit / largest_channel(c)) * texel_solid_angle(panorama, y);
    const in_double::vec3 d =
        in_double::direction_from_equirectangular({(x + 0.5) / panorama.width, (y + 0.5) / panorama.height});
    return {{static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)},
            {static_cast<float>(c.r * excess), static_cast<float>(c.g * excess),
             static_cast<float>(c.b * excess)}};
}

// Range of texels that the interval of angles about `along` (over `axis`) covers, by projection on the face.
void covered(double along, double axis, double radius, int size, int& first, int& last)
{
    const double length = std::hypot(along, axis);
    const double sine = std::sin(std::min(radius, std::numbers::pi / 2)) / std::max(length, 1e-12);
    const double half = sine >= 1.0 || radius >= std::numbers::pi / 2 ? std::numbers::pi : std::asin(sine);
    const double middle = std::atan2(along, axis), quarter = std::numbers::pi / 4;
    if (middle - half > quarter || middle + half < -quarter) {
        first = 0;
        last = -1;
        return;
    }
    const auto texel = [size](double angle) {
        return static_cast<int>(std::floor((std::tan(angle) * 0.5 + 0.5) * size));
    };
    first = std::clamp(texel(std::max(middle - half, -quarter)), 0, size - 1);
    last = std::clamp(texel(std::min(middle + half, quarter)), 0, size - 1);
}

// Calls visit(face, x, y, weight) for each texel that the Gaussian reaches; weight is not normalised.
template <class Visit>
void for_each_reached(const Peak& peak, double deviation, int size, Visit&& visit)
{
    constexpr double reach = 3.5;
    const in_double::vec3 d(peak.direction[0], peak.direction[1], peak.direction[2]);
    for (int face = 0; face < 6; ++face) {
        const TexelBox box = texels_within(peak, reach * deviation, face, size);
        for (int y = box.y0; y <= box.y1; ++y)
            for (int x = box.x0; x <= box.x1; ++x) {
                const Direction t =
                    cube_direction(face, (2.0 * x + 1.0) / size - 1.0, (2.0 * y + 1.0) / size - 1.0);
                const double angle = std::acos(std::clamp(t.x * d.x + t.y * d.y + t.z * d.z, -1.0, 1.0));
                if (angle < reach * deviation)
                    visit(face, x, y, std::exp(-0.5 * angle * angle / (deviation * deviation)));
            }
    }
}

} // namespace

TexelBox texels_within(const Peak& peak, double radius, int face, int face_size)
{
    const in_double::vec3 d(peak.direction[0], peak.direction[1], peak.direction[2]);
    const in_double::vec3 axis = in_double::direction_from_cube(face, 0.0, 0.0);
    const in_double::vec3 right = in_double::direction_from_cube(face, 1.0, 0.0) - axis;
    const in_double::vec3 down = in_double::direction_from_cube(face, 0.0, 1.0) - axis;
    TexelBox box{};
    covered(dot(d, right), dot(d, axis), radius, face_size, box.x0, box.x1);
    covered(dot(d, down), dot(d, axis), radius, face_size, box.y0, box.y1);
    return box;
}

Peaks find_peaks(const Panorama& panorama)
{
    Peaks result;
    double limit = least_over_mean * mean_radiance(panorama);
    const double most = most_of_all * static_cast<double>(panorama.texels.size());
    while (limit > 0.0 && static_cast<double>(texels_above(panorama, limit)) > most)
        limit *= 2.0;
    result.limit = static_cast<float>(limit);
    if (limit <= 0.0)
        return result;
    for (int y = 0; y < panorama.height; ++y)
        for (int x = 0; x < panorama.width; ++x)
            if (largest_channel(panorama.radiance(x, y)) > limit)
                result.peaks.push_back(cut_off(panorama, x, y, limit));
    return result;
}

std::vector<Peak> merged(const std::vector<Peak>& peaks, float spacing)
{
    struct Sum {
        double light[3] = {}, moment[3] = {};
    };
    // Cells of a cube grid of about the spacing: peaks of one cell become one.
    const int size = std::max(1, static_cast<int>(std::numbers::pi / 2 / spacing));
    std::map<int, Sum> cells;
    for (const Peak& peak : peaks) {
        const FacePosition p = cube_position({peak.direction[0], peak.direction[1], peak.direction[2]});
        const auto cell = [size](double s) {
            return std::clamp(static_cast<int>((s * 0.5 + 0.5) * size), 0, size - 1);
        };
        Sum& sum = cells[(p.face * size + cell(p.t)) * size + cell(p.s)];
        for (int k = 0; k < 3; ++k) {
            sum.light[k] += peak.light[k];
            sum.moment[k] += peak.direction[k] * (peak.light[0] + peak.light[1] + peak.light[2]);
        }
    }
    std::vector<Peak> result;
    for (const auto& [key, sum] : cells) {
        const double length = std::hypot(sum.moment[0], sum.moment[1], sum.moment[2]);
        Peak peak{};
        for (int k = 0; k < 3; ++k) {
            peak.light[k] = static_cast<float>(sum.light[k]);
            peak.direction[k] = static_cast<float>(sum.moment[k] / length);
        }
        result.push_back(peak);
    }
    return result;
}

void add_gaussians(const std::vector<Peak>& peaks, float deviation, int level, CubeChain& chain)
{
    const int size = chain.face_size(level);
    for (const Peak& peak : peaks) {
        double total = 0.0;
        for_each_reached(peak, deviation, size, [&](int, int x, int y, double weight) {
            total += weight * cube_texel_solid_angle(size, x, y);
        });
        for_each_reached(peak, deviation, size, [&](int face, int x, int y, double weight) {
            std::uint16_t* texel = chain.halfs() + 3 * chain.texel(level, face, x, y);
            const float share = static_cast<float>(weight / total) / chain.scale;
            for (int k = 0; k < 3; ++k)
                texel[k] = to_half(from_half(texel[k]) + peak.light[k] * share);
        });
    }
}

} // namespace lambent::environment
