#include "environment/sky/sun_disc.h"

#include "environment/sky/atmosphere.h"
#include "image/panorama_lookup.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lambent::environment {
namespace {

using std::numbers::pi;

// The limb's radiance falls as the cosine at the sun's surface to this power: -0.023 + 0.292 / 0.55 micrometres.
constexpr double limb_exponent = 0.508;

// Least number of sample points across the disc.
constexpr double points_across = 48.0;

struct Vector {
    double x, y, z;
};

Vector direction(double azimuth, double elevation)
{
    return {std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
            std::cos(elevation) * std::sin(azimuth)};
}

// Radiance relative to the middle of the disc.
double brightness(const Vector& a, const Vector& centre)
{
    const double x = a.x - centre.x, y = a.y - centre.y, z = a.z - centre.z;
    const double square = (x * x + y * y + z * z) / (sun_radius * sun_radius);
    return square < 1.0 ? std::pow(1.0 - square, 0.5 * limb_exponent) : 0.0;
}

// Shares of the disc's light that belong to each texel of the rows it touches.
class Shares {
public:
    Shares(const SunDisc& sun, int width, int height)
        : width_(width), height_(height), centre_(direction(sun.azimuth, sun.elevation))
    {
        const double zenith_angle = 0.5 * pi - sun.elevation, step = pi / height;
        first_row_ = std::max(0, static_cast<int>(std::floor((zenith_angle - sun_radius) / step)) - 1);
        const int last_row =
            std::min(height - 1, static_cast<int>(std::floor((zenith_angle + sun_radius) / step)) + 1);
        rows_ = last_row - first_row_ + 1;
        shares_.resize(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(width));
        const double points = std::ceil(points_across * step / (2.0 * sun_radius));
        for (int row = first_row_; row <= last_row; ++row)
            add_row(row, sun, static_cast<int>(points));
    }

    // Calls visit(x, y, share) for each texel with a share; shares add up to 1 if nothing is hidden.
    template <class Visit>
    void each(Visit&& visit) const
    {
        for (std::size_t i = 0; i < shares_.size(); ++i)
            if (shares_[i] > 0.0)
                visit(static_cast<int>(i) % width_, first_row_ + static_cast<int>(i) / width_,
                      shares_[i] / whole_);
    }

private:
    // The number of columns on either side of the disc's centre that it may touch in a row. It is largest at the row's
    // upper edge, which is closer to the zenith.
    int half_columns(int row) const
    {
        const double sine = std::sin(row * pi / height_);
        const double angle = sine > sun_radius ? std::asin(std::min(1.0, sun_radius / sine)) : pi;
        return std::min(width_ / 2, static_cast<int>(std::ceil(2.0 * angle / (2.0 * pi) * width_)) + 1);
    }

    void add_row(int row, const SunDisc& sun, int points)
    {
        const double step = pi / height_;
        const double sine = std::sin(std::clamp((row + 0.5) * step, 0.0, pi));
        const int across = std::max(2, static_cast<int>(std::ceil(points * sine)));
        const int middle = static_cast<int>(std::floor((sun.azimuth / (2.0 * pi) + 0.5) * width_));
        const int half = half_columns(row);
        for (int j = 0; j < points; ++j) {
            const double y = row + (j + 0.5) / points;
            const double elevation = 0.5 * pi - y * step;
            for (int i = 0; i < 2 * half * across; ++i) {
                const double x = middle - half + (i + 0.5) / across;
                const double azimuth = image::column_azimuth(x, width_);
                const double weight = brightness(direction(azimuth, elevation), centre_) *
                                      std::cos(elevation) / (across * points);
                whole_ += weight;
                if (weight > 0.0 && elevation > sun.ground_edge)
                    share_out(x - 0.5, y - 0.5, weight);
            }
        }
    }

    void share_out(double x, double y, double weight)
    {
        const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
        const double right_share = x - left, bottom_share = y - top;
        add(left, top, weight * (1.0 - right_share) * (1.0 - bottom_share));
        add(left + 1, top, weight * right_share * (1.0 - bottom_share));
        add(left, top + 1, weight * (1.0 - right_share) * bottom_share);
        add(left + 1, top + 1, weight * right_share * bottom_share);
    }

    void add(int x, int y, double weight)
    {
        const image::PanoramaTexel at = image::texel_across(x, y, width_, height_);
        const int row = std::clamp(at.y - first_row_, 0, rows_ - 1);
        shares_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(at.x)] += weight;
    }

    int width_, height_, first_row_ = 0, rows_ = 0;
    Vector centre_;
    double whole_ = 0.0;
    std::vector<double> shares_;
};

} // namespace

void add_sun(const SunDisc& sun, image::RadianceImage& panorama)
{
    const int width = panorama.width, height = panorama.height;
    Shares(sun, width, height).each([&](int x, int y, double share) {
        const float radiance = static_cast<float>(share / image::texel_solid_angle(width, height, y));
        float* texel = panorama.pixel(x, y);
        texel[0] += radiance * sun.irradiance.r;
        texel[1] += radiance * sun.irradiance.g;
        texel[2] += radiance * sun.irradiance.b;
    });
}

} // namespace lambent::environment
