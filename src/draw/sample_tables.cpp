#include "draw/sample_tables.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::draw {
namespace {

// The plastic number, the real root of p^3 = p + 1: its powers spread points over a square as the golden ratio does
// over a line. [Roberts 2018, "The unreasonable effectiveness of quasirandom sequences"]
constexpr double plastic = 1.32471795724474602596;

double fraction(double x)
{
    return x - std::floor(x);
}

using Lobe = SampleTables::Lobe;

Lobe lobe_point(double xi1, double xi2)
{
    const double phi = 2.0 * std::numbers::pi * xi1;
    return {static_cast<float>(std::log2(xi2)), static_cast<float>(std::cos(phi)),
            static_cast<float>(std::sin(phi))};
}

Lobe hammersley(int i, int count)
{
    // The first radical inverse is 0, a direction perpendicular to the lobe's axis, but its logarithm has to be finite.
    const double xi2 = std::max(radical_inverse(static_cast<unsigned>(i)), 0x1p-1000);
    return lobe_point(static_cast<double>(i) / count, xi2);
}

// Moves the mean of the points to (0, 0): otherwise they would shift reflections.
void centre(std::vector<SampleTables::Pixel>& points)
{
    double x = 0.0, y = 0.0;
    for (const SampleTables::Pixel& point : points)
        x += static_cast<double>(point.x), y += static_cast<double>(point.y);
    const double count = static_cast<double>(points.size());
    for (SampleTables::Pixel& point : points) {
        point.x -= static_cast<float>(x / count);
        point.y -= static_cast<float>(y / count);
    }
}

} // namespace

double radical_inverse(unsigned i)
{
    double result = 0.0, digit = 0.5;
    for (; i > 0; i >>= 1, digit *= 0.5)
        result += (i & 1) * digit;
    return result;
}

SampleTables make_sample_tables(int count, LobePoints points)
{
    SampleTables tables;
    for (int i = 0; i < count; ++i) {
        const double golden = fraction(i / std::numbers::phi), middle = (i + 0.5) / count;
        const double turn = 2.0 * std::numbers::pi * golden;
        // Slightly towards the centre: the outermost samples represent the tail beyond them, most of which is near.
        tables.cap.push_back({static_cast<float>((i + 0.4) / (count + 1.0)),
                              static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn))});
        tables.lobe.push_back(points == LobePoints::spiral ? lobe_point(golden, middle)
                                                           : hammersley(i, count));
        tables.pixel.push_back({static_cast<float>(fraction(0.5 + i / plastic) - 0.5),
                                static_cast<float>(fraction(0.5 + i / (plastic * plastic)) - 0.5)});
    }
    centre(tables.pixel);
    return tables;
}

} // namespace lambent::draw
