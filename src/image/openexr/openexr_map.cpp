#include "image/openexr/openexr_map.h"

#include "equations/in_double.h"
#include "image/panorama_rows.h"
#include "image/refuse.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lambent::image {
namespace {

constexpr double pi = std::numbers::pi;

// Lookups per texel along each axis: enough to miss none of a cube's pixels, which are smallest at the corners.
constexpr int points_across = 5;

using Direction = in_double::vec3;

// A position in a map in pixels, relative to the centre of the first.
struct MapPosition {
    double x, y;
};

// Longitude 0 is +Z, in the middle; longitudes increase to the left, towards +X.
MapPosition position_in_latitude_longitude(const RadianceImage& map, const Direction& d)
{
    const double longitude = std::atan2(d.x, d.z), polar = std::acos(std::clamp(d.y, -1.0, 1.0));
    return {(0.5 - longitude / (2.0 * pi)) * (map.width - 1), polar / pi * (map.height - 1)};
}

// The faces are stacked from top to bottom, each as seen from outside: those of equations/sphere_maps.glsl mirrored.
MapPosition position_in_cube(const RadianceImage& map, const Direction& d)
{
    const in_double::CubePlace at = in_double::cube_from_direction(d);
    const int face = static_cast<int>(at.face);
    const bool up_or_down =
        face == 2 || face == 3; // mirrored from top to bottom, the others from left to right
    const double s = up_or_down ? at.s : -at.s, t = up_or_down ? -at.t : at.t, last = map.width - 1;
    return {std::clamp(0.5 * (s + 1.0), 0.0, 1.0) * last,
            face * map.width + std::clamp(0.5 * (t + 1.0), 0.0, 1.0) * last};
}

class MapReader : public RadianceReader {
public:
    MapReader(std::unique_ptr<RadianceReader> map, const std::string& name)
        : source_(std::move(map)), cube_(source_->projection() == Projection::cube),
          across_(cube_ ? points_across : 1)
    {
        width_ = cube_ ? 4 * source_->width() : source_->width();
        height_ = cube_ ? 2 * source_->width() : source_->height();
        check_size(name, width_, height_);
        warnings_ = source_->warnings();
    }

    void read_rows(int count, float* rgb) override
    {
        if (map_.values.empty()) {
            map_ = read_all_rows(*source_);
            // +X is in the middle column, +Z a quarter of the width to its right.
            for (int x = 0; x < across_ * width_; ++x) {
                const double phi = column_azimuth(x + 0.5, across_ * width_);
                turns_.push_back({std::cos(phi), std::sin(phi)});
            }
        }
        tbb::parallel_for(0, count, [&](int i) {
            fill_row(row_ + i, rgb + 3 * static_cast<std::size_t>(i) * static_cast<std::size_t>(width_));
        });
        row_ += count;
    }

private:
    struct Turn {
        double cosine, sine;
    };

    void fill_row(int y, float* rgb) const
    {
        std::fill_n(rgb, 3 * static_cast<std::size_t>(width_), 0.0f);
        const auto polar = [&](int j) { return (y + (j + 0.5) / across_) / height_ * pi; };
        double rings = 0.0;
        for (int j = 0; j < across_; ++j)
            rings += std::sin(polar(j));
        for (int j = 0; j < across_; ++j) {
            const double up = std::cos(polar(j)), ring = std::sin(polar(j));
            const float share = static_cast<float>(ring / (rings * across_));
            for (int i = 0; i < across_ * width_; ++i) {
                const Turn turn = turns_[static_cast<std::size_t>(i)];
                const Direction d(ring * turn.cosine, up, ring * turn.sine);
                add(cube_ ? position_in_cube(map_, d) : position_in_latitude_longitude(map_, d), share,
                    rgb + 3 * (i / across_));
            }
        }
    }

    // Adds a bilinear lookup times `factor` to `rgb`.
    void add(const MapPosition& at, float factor, float* rgb) const
    {
        const int left = std::clamp(static_cast<int>(at.x), 0, map_.width - 1);
        const int top = std::clamp(static_cast<int>(at.y), 0, map_.height - 1);
        const int right = std::min(left + 1, map_.width - 1), bottom = std::min(top + 1, map_.height - 1);
        const float fx = static_cast<float>(at.x - left), fy = static_cast<float>(at.y - top);
        const float *a = map_.pixel(left, top), *b = map_.pixel(right, top);
        const float *c = map_.pixel(left, bottom), *d = map_.pixel(right, bottom);
        const float weights[4] = {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
        // Pixels without weight are skipped, because they may be infinite.
        for (const auto& [pixel, weight] :
             {std::pair(a, weights[0]), {b, weights[1]}, {c, weights[2]}, {d, weights[3]}})
            if (weight > 0.0f)
                for (int k = 0; k < 3; ++k)
                    rgb[k] += factor * weight * pixel[k];
    }

    std::unique_ptr<RadianceReader> source_;
    bool cube_;
    int across_; // lookups per texel along each axis
    RadianceImage map_;
    std::vector<Turn> turns_; // azimuth of each column of lookups
    int row_ = 0;
};

} // namespace

std::unique_ptr<RadianceReader> as_equirectangular(std::unique_ptr<RadianceReader> reader,
                                                   const std::string& name)
{
    if (reader->projection() == Projection::unknown)
        return reader;
    return std::make_unique<MapReader>(std::move(reader), name);
}

} // namespace lambent::image
