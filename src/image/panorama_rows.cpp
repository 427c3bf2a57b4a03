#include "image/panorama_rows.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace lambent::image {
namespace {

// Angle between the row at `angle` and the row above it, by Newton's method from `usual`, such that the mean cosine
// between them is `edge`, the cosine of the angle where their texels meet. All rows above that edge then contribute as
// much light as their texels, and hence each single row does.
double step_up(double angle, double edge, double usual)
{
    double step = usual;
    for (int i = 0; i < 8; ++i) {
        const double mean = std::cos(angle - 0.5 * step) * std::sin(0.5 * step) / (0.5 * step);
        step += 2.0 * (edge - mean) / std::sin(angle - 0.5 * step);
    }
    return step;
}

} // namespace

std::vector<double> row_angles(int height)
{
    const double row = std::numbers::pi / height;
    const int middle = height / 2; // the row at the horizon, or just below it if their number is even
    std::vector<double> angles(static_cast<std::size_t>(height));
    double angle = height % 2 == 1 ? 0.5 * std::numbers::pi : 0.5 * std::numbers::pi + 0.5 * row;
    for (int y = middle; y >= 0; --y) {
        angles[static_cast<std::size_t>(y)] = angle;
        angles[static_cast<std::size_t>(height - 1 - y)] = std::numbers::pi - angle;
        if (y > 0)
            angle -= step_up(angle, std::cos(row * y), row);
    }
    return angles;
}

double texel_solid_angle(int width, int height, int y)
{
    const double step = std::numbers::pi / height;
    return 2.0 * std::numbers::pi / width * (std::cos(y * step) - std::cos((y + 1) * step));
}

PanoramaRows::PanoramaRows(int height) : height_(height), positions_(row_angles(height))
{
    for (double& position : positions_)
        position /= std::numbers::pi;
    positions_.insert(positions_.begin(), -positions_.front());
    positions_.push_back(2.0 - positions_.back());
}

} // namespace lambent::image
