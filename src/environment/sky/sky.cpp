#include "environment/sky/sky.h"

#include "environment/sky/sky_table.h"
#include "environment/sky/sun_disc.h"
#include "image/panorama_rows.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

using std::numbers::pi;

// From nits or lux to the panorama's unit. Colours beyond Rec. 709 lose their negative part.
Rgb in_units(const Rgb& c)
{
    constexpr float unit = 1.0f / sky_nits_per_unit;
    return {std::max(0.0f, unit * c.r), std::max(0.0f, unit * c.g), std::max(0.0f, unit * c.b)};
}

// Azimuth in the panorama of a direction at a camera's azimuth: the panorama's middle is +X and +Z lies to its right, a
// camera's azimuth starts at +Z and turns towards +X.
double panorama_azimuth(float camera_azimuth)
{
    return std::remainder(0.5 * pi - static_cast<double>(camera_azimuth), 2.0 * pi);
}

// Values that the texels of one column share.
struct Column {
    int angle;      // index of the table's last angle before this column
    float fraction; // position between that angle and the next
    float cosine;   // of the horizontal angle from the sun
};

std::vector<Column> make_columns(int width, double sun_azimuth, int angles)
{
    std::vector<Column> columns;
    for (int x = 0; x < width; ++x) {
        const double azimuth = image::column_azimuth(x + 0.5, width);
        const double from_sun = std::fabs(std::remainder(azimuth - sun_azimuth, 2.0 * pi));
        const double position = from_sun / pi * (angles - 1);
        const int angle = std::min(static_cast<int>(position), angles - 2);
        columns.push_back(
            {angle, static_cast<float>(position - angle), static_cast<float>(std::cos(from_sun))});
    }
    return columns;
}

// Cosine of the angle to the sun in a row of the panorama: level + across * (cosine of the horizontal angle).
struct RowGeometry {
    double level, across;
    double ring; // strength of the ring around the sun
};

void fill_row(const SkyTable::Row& row, const RowGeometry& geometry, const std::vector<Column>& columns,
              float* texels)
{
    for (const Column& column : columns) {
        const double cosine = geometry.level + geometry.across * static_cast<double>(column.cosine);
        const float air = static_cast<float>(air_phase(cosine));
        const float haze = static_cast<float>(haze_phase(cosine, geometry.ring));
        const SkyLight light = between(row, column.angle, column.fraction);
        const Rgb sum = in_units({air * light.air.r + haze * light.haze.r + light.even.r,
                                  air * light.air.g + haze * light.haze.g + light.even.g,
                                  air * light.air.b + haze * light.haze.b + light.even.b});
        *texels++ = sum.r;
        *texels++ = sum.g;
        *texels++ = sum.b;
    }
}

} // namespace

image::RadianceImage make_sky(const SkyOptions& options)
{
    const int width = options.width, height = width / 2;
    image::RadianceImage panorama = image::black_image(width, height);
    const double sun_elevation = std::min(static_cast<double>(options.sun_elevation), 0.5 * pi);
    const double sun_azimuth = panorama_azimuth(options.sun_azimuth);
    const ClearSky sky(sun_elevation, static_cast<double>(options.turbidity));
    const SkyTable table(sky);
    const std::vector<Column> columns = make_columns(width, sun_azimuth, SkyTableSize().angles);
    tbb::parallel_for(0, height, [&](int y) {
        const double elevation = (0.5 - (y + 0.5) / height) * pi;
        const RowGeometry geometry{std::sin(elevation) * std::sin(sun_elevation),
                                   std::cos(elevation) * std::cos(sun_elevation), sky.ring(elevation)};
        fill_row(table.row(elevation), geometry, columns, panorama.pixel(0, y));
    });
    const Rgb sun = in_units(sky.sun_illuminance());
    add_sun({sun_azimuth, sun_elevation, sky.ground_edge(), sun}, panorama);
    return panorama;
}

} // namespace lambent::environment
