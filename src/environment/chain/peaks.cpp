#include "environment/chain/peaks.h"

#include "environment/chain/cube_faces.h"
#include "equations/in_double.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>

namespace lambent::environment {
namespace {

constexpr double least_over_mean = 16.0;    // the limit over the mean radiance
constexpr double most_of_all = 1.0 / 128.0; // share of the sphere above the limit
// Solid angle above the limit, in texels at the horizon: at any resolution, lights of more than a few texels need no
// special treatment.
constexpr double most_texels = 3000.0;

double largest_channel(const Rgb& c)
{
    return std::max(c.r, std::max(c.g, c.b));
}

// A histogram of brightness, the largest channel: its integral over the sphere, and the solid angle in each quarter of
// an octave. (Not the number of texels: rows near a pole have as many as any other.)
struct Brightness {
    static constexpr int bins = 1024;

    double integral = 0.0;
    std::array<double, bins> solid_angle = {};

    static std::size_t bin(float value) { return std::bit_cast<std::uint32_t>(value) >> 21; }
    static float start(std::size_t bin)
    {
        return std::bit_cast<float>(static_cast<std::uint32_t>(bin << 21));
    }
};

Brightness sum(Brightness a, const Brightness& b)
{
    a.integral += b.integral;
    for (std::size_t i = 0; i < a.solid_angle.size(); ++i)
        a.solid_angle[i] += b.solid_angle[i];
    return a;
}

// Also sets `brightest` to the largest channel in each row.
Brightness measure(const Panorama& panorama, std::vector<float>& brightest)
{
    const auto add_rows = [&](const tbb::blocked_range<int>& rows, Brightness total) {
        for (int y = rows.begin(); y < rows.end(); ++y) {
            float light = 0.0f, most = 0.0f;
            std::array<std::uint32_t, Brightness::bins> count = {};
            const std::uint32_t* texels =
                panorama.texels.data() +
                static_cast<std::size_t>(y) * static_cast<std::size_t>(panorama.width);
            for (int x = 0; x < panorama.width; ++x) {
                const Rgb c = unpack_rgb9e5(texels[x]);
                const float value = panorama.scale * std::max(c.r, std::max(c.g, c.b));
                light += value;
                most = std::max(most, value);
                ++count[Brightness::bin(value)];
            }
            const double texel = texel_solid_angle(panorama, y);
            total.integral += static_cast<double>(light) * texel;
            for (std::size_t i = 0; i < count.size(); ++i)
                total.solid_angle[i] += count[i] * texel;
            brightest[static_cast<std::size_t>(y)] = most;
        }
        return total;
    };
    return tbb::parallel_reduce(tbb::blocked_range<int>(0, panorama.height, 16), Brightness(), add_rows, sum);
}

// The lowest start of a bin above which the solid angle is within the bounds.
float choose_limit(const Brightness& brightness, double horizon_texel)
{
    const double mean = brightness.integral / (4.0 * std::numbers::pi);
    const double most = std::min(most_of_all * 4.0 * std::numbers::pi, most_texels * horizon_texel);
    const std::size_t least = Brightness::bin(static_cast<float>(least_over_mean * mean)) + 1;
    std::size_t bin = Brightness::bins - 1;
    double above = 0.0;
    while (bin > least && above + brightness.solid_angle[bin] <= most)
        above += brightness.solid_angle[bin--];
    // The bin itself does not fit wholly, or it is the lowest allowed.
    return Brightness::start(bin < least ? least : bin + (bin > least ? 1 : 0));
}

// How many texels of a row are together about as wide as high: many near a pole.
int texels_of_a_peak(const Panorama& panorama, int y)
{
    const double sine = std::sin((y + 0.5) / panorama.height * std::numbers::pi);
    const double across = panorama.width / (2.0 * panorama.height * sine);
    return std::clamp(static_cast<int>(across), 1, std::max(panorama.width / 8, 1));
}

// The light of texels [first, end) of a row above the limit, at its centroid.
Peak cut_off(const Panorama& panorama, int y, int first, int end, double limit)
{
    const double solid_angle = texel_solid_angle(panorama, y);
    double light[3] = {}, moment[3] = {};
    for (int x = first; x < end; ++x) {
        const Rgb c = panorama.radiance(x, y);
        const double excess = std::max(1.0 - limit / std::max(largest_channel(c), 1e-300), 0.0) * solid_angle;
        const in_double::vec3 d = in_double::direction_from_equirectangular(
            {(x + 0.5) / panorama.width, (y + 0.5) / panorama.height});
        const double rgb[3] = {c.r * excess, c.g * excess, c.b * excess};
        const double axes[3] = {d.x, d.y, d.z};
        for (int k = 0; k < 3; ++k) {
            light[k] += rgb[k];
            moment[k] += axes[k] * (rgb[0] + rgb[1] + rgb[2]);
        }
    }
    const double length = std::max(std::hypot(moment[0], moment[1], moment[2]), 1e-300);
    Peak peak{};
    for (int k = 0; k < 3; ++k) {
        peak.direction[k] = static_cast<float>(moment[k] / length);
        peak.light[k] = static_cast<float>(light[k]);
    }
    return peak;
}

void cut_off_row(const Panorama& panorama, int y, float limit, std::vector<Peak>& peaks)
{
    const int step = texels_of_a_peak(panorama, y);
    for (int x = 0; x < panorama.width; x += step) {
        const int end = std::min(x + step, panorama.width);
        float most = 0.0f;
        for (int i = x; i < end; ++i) {
            const Rgb c = panorama.radiance(i, y);
            most = std::max(most, std::max(c.r, std::max(c.g, c.b)));
        }
        if (most > limit)
            peaks.push_back(cut_off(panorama, y, x, end, static_cast<double>(limit)));
    }
}

// The first and last of consecutive texels.
struct Interval {
    int first, last;
};

// The texels, in one coordinate of a face, within `radius` radians of a direction whose components are `along` that
// coordinate and along the face's `axis`; 0 to -1 if there are none.
Interval covered(double along, double axis, double radius, int size)
{
    const double length = std::hypot(along, axis);
    const double sine = std::sin(std::min(radius, std::numbers::pi / 2)) / std::max(length, 1e-12);
    const double half = sine >= 1.0 || radius >= std::numbers::pi / 2 ? std::numbers::pi : std::asin(sine);
    const double middle = std::atan2(along, axis), quarter = std::numbers::pi / 4;
    if (middle - half > quarter || middle + half < -quarter)
        return {0, -1};
    const auto texel = [size](double angle) {
        const int i = static_cast<int>(std::floor((std::tan(angle) * 0.5 + 0.5) * size));
        return std::clamp(i, 0, size - 1);
    };
    return {texel(std::max(middle - half, -quarter)), texel(std::min(middle + half, quarter))};
}

// A texel that a peak's Gaussian reaches, and the Gaussian's value there.
struct Reached {
    std::uint16_t* texel;
    double weight;
};

// Finds the texels that a peak's Gaussian reaches; returns the sum of their weights times solid angles.
double reach(const Peak& peak, double deviation, int level, CubeChain& chain, std::vector<Reached>& reached)
{
    constexpr double furthest = 3.5;
    const int size = chain.face_size(level);
    const in_double::vec3 d(peak.direction[0], peak.direction[1], peak.direction[2]);
    const double texel = 2.0 / size;
    double total = 0.0;
    reached.clear();
    for (int face = 0; face < 6; ++face) {
        const TexelBox box = texels_within(peak, furthest * deviation, face, size);
        for (int y = box.y0; y <= box.y1; ++y)
            for (int x = box.x0; x <= box.x1; ++x) {
                const double s = (x + 0.5) * texel - 1.0, t = (y + 0.5) * texel - 1.0;
                const double cube = 1.0 / std::sqrt(1.0 + s * s + t * t);
                const double cosine = cube * dot(in_double::direction_from_cube(face, s, t), d);
                // The squared angle from the squared chord; the error is 1e-4 at one radian.
                const double chord = std::max(2.0 - 2.0 * cosine, 0.0);
                const double square = chord * (1.0 + chord * (1.0 / 12.0 + chord / 90.0));
                const double deviations = square / (deviation * deviation);
                if (deviations > furthest * furthest)
                    continue;
                const double weight = std::exp(-0.5 * deviations);
                // At fine levels the solid angle is evaluated at the texel's centre.
                const double area =
                    size >= 64 ? texel * texel * cube * cube * cube : cube_texel_solid_angle(size, x, y);
                reached.push_back({chain.halfs() + 3 * chain.texel(level, face, x, y), weight});
                total += weight * area;
            }
    }
    return total;
}

} // namespace

TexelBox texels_within(const Peak& peak, double radius, int face, int face_size)
{
    const in_double::vec3 d(peak.direction[0], peak.direction[1], peak.direction[2]);
    const in_double::vec3 axis = in_double::direction_from_cube(face, 0.0, 0.0);
    const in_double::vec3 right = in_double::direction_from_cube(face, 1.0, 0.0) - axis;
    const in_double::vec3 down = in_double::direction_from_cube(face, 0.0, 1.0) - axis;
    const Interval x = covered(dot(d, right), dot(d, axis), radius, face_size);
    const Interval y = covered(dot(d, down), dot(d, axis), radius, face_size);
    return {x.first, x.last, y.first, y.last};
}

Peaks find_peaks(const Panorama& panorama)
{
    std::vector<float> brightest(static_cast<std::size_t>(panorama.height));
    const Brightness brightness = measure(panorama, brightest);
    Peaks result;
    result.brightest = *std::max_element(brightest.begin(), brightest.end());
    const double step = std::numbers::pi / panorama.height;
    result.limit = choose_limit(brightness, 2.0 * std::numbers::pi / panorama.width * step);
    for (int y = 0; y < panorama.height; ++y)
        if (brightest[static_cast<std::size_t>(y)] > result.limit)
            cut_off_row(panorama, y, result.limit, result.peaks);
    return result;
}

std::vector<Peak> merged(const std::vector<Peak>& peaks, float spacing)
{
    struct Sum {
        double light[3] = {}, moment[3] = {};
    };
    // Peaks in one cell of a cube grid of about that spacing become one.
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
    std::vector<Reached> reached;
    for (const Peak& peak : peaks) {
        const double total = reach(peak, static_cast<double>(deviation), level, chain, reached);
        for (const auto& [texel, weight] : reached) {
            const float share = static_cast<float>(weight / total) / chain.scale;
            for (int k = 0; k < 3; ++k)
                texel[k] = to_half(from_half(texel[k]) + peak.light[k] * share);
        }
    }
}

} // namespace lambent::environment
