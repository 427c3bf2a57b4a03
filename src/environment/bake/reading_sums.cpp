// Sums over a panorama interpolated linearly between its texels, for panoramas too small to treat texels as points.
#include "environment/bake/reading_sums.h"

#include "environment/bake/light_points.h"
#include "environment/bake/sum_rows.h"
#include "image/panorama_lookup.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

// Least number of points around a row.
constexpr int least_points = 1536;

// A row of points: its polar angle, the rows of texels above and below it, and the solid angles of each point that have
// the light of either. Rows -1 and the height are those beyond the poles.
struct PointRow {
    double angle;
    int above, below;
    double from_above, from_below;
};

// Points at the centres of equal parts between each two rows, weighted so that each row has its texels' solid angle.
std::vector<PointRow> rows_of_points(const Panorama& panorama, int parts)
{
    const int last = panorama.height - 1;
    const std::vector<double> angles = image::row_angles(panorama.height);
    std::vector<PointRow> rows;
    std::vector<double> sums(angles.size());
    const auto row_within = [last](int row) { return static_cast<std::size_t>(std::clamp(row, 0, last)); };
    for (int below = 0; below <= last + 1; ++below) {
        const double start = below > 0 ? angles[static_cast<std::size_t>(below) - 1] : 0.0;
        const double end = below <= last ? angles[static_cast<std::size_t>(below)] : std::numbers::pi;
        for (int i = 0; i < parts; ++i) {
            const double part = (i + 0.5) / parts, angle = start + part * (end - start);
            // Next to a pole lies only half of the interval between a row and the one beyond the pole.
            const double share = below == 0 ? 0.5 + 0.5 * part : below > last ? 0.5 * part : part;
            const double area = std::sin(angle) * (end - start);
            rows.push_back({angle, below - 1, below, (1.0 - share) * area, share * area});
            sums[row_within(below - 1)] += rows.back().from_above;
            sums[row_within(below)] += rows.back().from_below;
        }
    }
    for (PointRow& row : rows) {
        const std::size_t above = row_within(row.above), below = row_within(row.below);
        row.from_above *= texel_solid_angle(panorama, static_cast<int>(above)) / sums[above] / parts;
        row.from_below *= texel_solid_angle(panorama, static_cast<int>(below)) / sums[below] / parts;
    }
    return rows;
}

class Reading {
public:
    explicit Reading(const Panorama& panorama)
        : panorama_(panorama), parts_(std::max(2, (least_points + panorama.width - 1) / panorama.width)),
          rows_(rows_of_points(panorama, parts_))
    {
    }

    int rows() const { return static_cast<int>(rows_.size()); }

    void add(int index, LightPoints& points, std::vector<TexelSum>& sums) const
    {
        load(rows_[static_cast<std::size_t>(index)], points);
        const std::size_t count =
            static_cast<std::size_t>(panorama_.width) * static_cast<std::size_t>(parts_);
        for (TexelSum& sum : sums)
            add_points(points, {0, count}, sum);
    }

private:
    Rgb texel(int x, int row) const
    {
        const image::PanoramaTexel at = image::texel_across(x, row, panorama_.width, panorama_.height);
        return panorama_.radiance(at.x, at.y);
    }

    void load(const PointRow& row, LightPoints& points) const
    {
        const double up = std::cos(row.angle), ring = std::sin(row.angle);
        points.resize(static_cast<std::size_t>(panorama_.width) * static_cast<std::size_t>(parts_));
        const auto light = [&](int x, float Rgb::*channel) {
            return row.from_above * static_cast<double>(texel(x, row.above).*channel) +
                   row.from_below * static_cast<double>(texel(x, row.below).*channel);
        };
        std::size_t at = 0;
        for (int x = 0; x < panorama_.width; ++x) {
            const int right = (x + 1) % panorama_.width;
            const double r[2] = {light(x, &Rgb::r), light(right, &Rgb::r)};
            const double g[2] = {light(x, &Rgb::g), light(right, &Rgb::g)};
            const double b[2] = {light(x, &Rgb::b), light(right, &Rgb::b)};
            for (int i = 0; i < parts_; ++i, ++at) {
                const double share = (i + 0.5) / parts_;
                const double phi = image::column_azimuth(x + 0.5 + share, panorama_.width);
                points.x[at] = ring * std::cos(phi), points.y[at] = up, points.z[at] = ring * std::sin(phi);
                points.r[at] = r[0] + share * (r[1] - r[0]);
                points.g[at] = g[0] + share * (g[1] - g[0]);
                points.b[at] = b[0] + share * (b[1] - b[0]);
            }
        }
    }

    const Panorama& panorama_;
    int parts_;
    std::vector<PointRow> rows_;
};

} // namespace

void sum_reading(const Panorama& panorama, std::span<TexelSum> sums)
{
    const Reading reading(panorama);
    sum_rows<LightPoints>(
        reading.rows(),
        [&](int row, LightPoints& points, std::vector<TexelSum>& total) { reading.add(row, points, total); },
        sums);
}

} // namespace lambent::environment
