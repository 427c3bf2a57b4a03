#include "reference/environment_light.h"

#include "equations/in_double.h"
#include "image/luminance.h"
#include "image/panorama_lookup.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::reference {
namespace {

using std::numbers::pi;

// The distributions of more cells than this do not fit a processor's caches.
constexpr int most_columns = 2048, most_rows = 1024;

// Cosine of the polar angle at the top of row y of `rows`.
double edge_cosine(int y, int rows)
{
    return std::cos(pi * y / rows);
}

} // namespace

EnvironmentLight::EnvironmentLight(const image::RadianceImage& panorama, double rotation)
    : panorama_(panorama), cosine_(std::cos(rotation)), sine_(std::sin(rotation)),
      picture_rows_(panorama.height)
{
    fill_cells();
}

// Approximate mean of the bilinear panorama over texel (x, y): weights 1/8, 3/4 and 1/8 along each axis.
double EnvironmentLight::smoothed_luminance(int x, int y) const
{
    double sum = 0.0;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            const image::PanoramaTexel at =
                image::texel_across(x + i, y + j, panorama_.width, panorama_.height);
            sum += (i == 0 ? 0.75 : 0.125) * (j == 0 ? 0.75 : 0.125) *
                   image::luminance(panorama_.pixel(at.x, at.y));
        }
    return sum;
}

// Mean over all texels that a cell overlaps, so that every cell that contains light can be drawn.
double EnvironmentLight::cell_light(int column, int row) const
{
    const auto begin = [](int cell, int texels, int cells) {
        return static_cast<int>(std::int64_t{cell} * texels / cells);
    };
    const auto end = [](int cell, int texels, int cells) {
        return static_cast<int>((std::int64_t{cell + 1} * texels + cells - 1) / cells);
    };
    const int y0 = begin(row, panorama_.height, rows_), y1 = end(row, panorama_.height, rows_);
    const int x0 = begin(column, panorama_.width, columns_), x1 = end(column, panorama_.width, columns_);
    double light = 0.0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            light += smoothed_luminance(x, y);
    return light / (static_cast<double>(y1 - y0) * (x1 - x0));
}

void EnvironmentLight::fill_cells()
{
    columns_ = std::min(panorama_.width, most_columns);
    rows_ = std::min(panorama_.height, most_rows);
    choices_.resize(static_cast<std::size_t>(rows_));
    cell_angle_.resize(static_cast<std::size_t>(rows_));
    std::vector<double> row_light(static_cast<std::size_t>(rows_));
    tbb::parallel_for(0, rows_, [&](int row) {
        const std::size_t index = static_cast<std::size_t>(row);
        std::vector<double> light;
        light.reserve(static_cast<std::size_t>(columns_));
        for (int column = 0; column < columns_; ++column)
            light.push_back(cell_light(column, row));
        choices_[index] = DiscreteDistribution<float>(light);
        cell_angle_[index] = 2.0 * pi / columns_ * (edge_cosine(row, rows_) - edge_cosine(row + 1, rows_));
        row_light[index] = choices_[index].sum() * cell_angle_[index];
    });
    row_choice_ = DiscreteDistribution<double>(row_light);
    for (int row = 0; row <= rows_; ++row)
        edge_cosines_.push_back(edge_cosine(row, rows_));
}

glm::dvec2 EnvironmentLight::place_of(const glm::dvec3& d) const
{
    const in_double::vec2 uv = in_double::equirectangular_from_direction(
        {cosine_ * d.x - sine_ * d.z, d.y, sine_ * d.x + cosine_ * d.z});
    return {uv.x, uv.y};
}

glm::dvec3 EnvironmentLight::radiance_at(const glm::dvec2& uv) const
{
    const std::array<double, 3> rgb = image::bilinear(
        image::columns_around(uv.x, panorama_.width), picture_rows_.around(uv.y), panorama_.width,
        panorama_.height, [this](int x, int y) { return panorama_.pixel(x, y); });
    return {rgb[0], rgb[1], rgb[2]};
}

double EnvironmentLight::cell_density(std::size_t row, std::size_t column) const
{
    return row_choice_.probability(row) * choices_[row].probability(column) / cell_angle_[row];
}

EnvironmentLight::Drawn EnvironmentLight::draw(const glm::dvec2& u) const
{
    if (!(row_choice_.sum() > 0.0))
        return {};
    const auto [row, below] = row_choice_.draw(u.y);
    const auto [column, right] = choices_[row].draw(u.x);
    const double top = edge_cosines_[row], bottom = edge_cosines_[row + 1];
    const double y = top + below * (bottom - top), sine = std::sqrt(std::max(1.0 - y * y, 0.0));
    const double across = (static_cast<double>(column) + right) / columns_, phi = (across - 0.5) * 2.0 * pi;
    const double px = sine * std::cos(phi), pz = sine * std::sin(phi);
    return {{cosine_ * px + sine_ * pz, y, cosine_ * pz - sine_ * px},
            {across, std::acos(std::clamp(y, -1.0, 1.0)) / pi},
            cell_density(row, column)};
}

double EnvironmentLight::density_at(const glm::dvec2& uv) const
{
    if (!(row_choice_.sum() > 0.0))
        return 0.0;
    const int column = std::clamp(static_cast<int>(uv.x * columns_), 0, columns_ - 1);
    const int row = std::clamp(static_cast<int>(uv.y * rows_), 0, rows_ - 1);
    return cell_density(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
}

} // namespace lambent::reference
