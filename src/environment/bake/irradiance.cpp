#include "environment/bake/irradiance.h"

#include "environment/chain/cube_faces.h"
#include "environment/panorama/resized.h"
#include "environment/bake/irradiance_kernel.h"
#include "equations/in_double.h"
#include "image/panorama_rows.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

// Most columns and rows of cells; time is proportional to their product. At 64x32 the error of irradiance is below
// 1e-3, at most h^2 / 12 for cells h radians high (tests/environment).
constexpr int most_cell_columns = 64, most_cell_rows = 32;

struct Trigonometry {
    std::vector<float> cosine, sine; // of the azimuth of each column
};

Trigonometry azimuths(int width)
{
    Trigonometry t;
    for (int x = 0; x < width; ++x) {
        const double phi = image::column_azimuth(x + 0.5, width);
        t.cosine.push_back(static_cast<float>(std::cos(phi)));
        t.sine.push_back(static_cast<float>(std::sin(phi)));
    }
    return t;
}

// Adds the texels of row y in columns [first, second) to a cell: light times direction.
void add_to_cell(const Panorama& p, const Trigonometry& t, int y, std::pair<int, int> columns,
                 double (*cell)[3])
{
    double plain[3] = {}, cosine[3] = {}, sine[3] = {};
    for (int x = columns.first; x < columns.second; ++x) {
        const Rgb c = p.radiance(x, y);
        const float rgb[3] = {c.r, c.g, c.b};
        for (int k = 0; k < 3; ++k) {
            plain[k] += rgb[k];
            cosine[k] += rgb[k] * t.cosine[static_cast<std::size_t>(x)];
            sine[k] += rgb[k] * t.sine[static_cast<std::size_t>(x)];
        }
    }
    const double theta = (y + 0.5) / p.height * std::numbers::pi, solid_angle = texel_solid_angle(p, y);
    for (int k = 0; k < 3; ++k) {
        cell[k][0] += solid_angle * std::sin(theta) * cosine[k];
        cell[k][1] += solid_angle * std::cos(theta) * plain[k];
        cell[k][2] += solid_angle * std::sin(theta) * sine[k];
    }
}

LightCells gather_cells(const Panorama& p)
{
    const int columns = std::min(p.width, most_cell_columns), rows = std::min(p.height, most_cell_rows);
    const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    LightCells cells;
    for (auto* axis : {&cells.x, &cells.y, &cells.z})
        for (auto& channel : *axis)
            channel.assign(count, 0.0f);
    const Trigonometry t = azimuths(p.width);
    tbb::parallel_for(0, rows, [&](int row) {
        std::vector<std::array<std::array<double, 3>, 3>> sums(static_cast<std::size_t>(columns));
        for (int y = row * p.height / rows; y < (row + 1) * p.height / rows; ++y)
            for (int column = 0; column < columns; ++column) {
                double cell[3][3] = {};
                add_to_cell(p, t, y, {column * p.width / columns, (column + 1) * p.width / columns}, cell);
                for (std::size_t k = 0; k < 3; ++k)
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        sums[static_cast<std::size_t>(column)][k][axis] += cell[k][axis];
            }
        for (std::size_t column = 0; column < sums.size(); ++column)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t index =
                    static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + column;
                cells.x[k][index] = static_cast<float>(sums[column][k][0]);
                cells.y[k][index] = static_cast<float>(sums[column][k][1]);
                cells.z[k][index] = static_cast<float>(sums[column][k][2]);
            }
    });
    return cells;
}

// A power of two by which irradiance fits into halfs: no normal receives more than if it faced all light.
float irradiance_scale(const LightCells& cells)
{
    double most = 1e-30;
    for (std::size_t k = 0; k < 3; ++k) {
        double sum = 0.0;
        for (std::size_t i = 0; i < cells.x[k].size(); ++i)
            sum += std::hypot(cells.x[k][i], cells.y[k][i], cells.z[k][i]);
        most = std::max(most, sum);
    }
    return static_cast<float>(std::exp2(std::ceil(std::log2(most / 65000.0))));
}

} // namespace

IrradianceMap make_irradiance_map(const Panorama& panorama, int face_size)
{
    const LightCells cells = gather_cells(panorama);
    IrradianceMap map;
    map.allocate(std::countr_zero(static_cast<unsigned>(face_size)), 1);
    map.scale = std::max(irradiance_scale(cells), 0x1p-14f);
    tbb::parallel_for(0, 6 * face_size,
                      [&](int row) { irradiance_row(cells, row / face_size, row % face_size, map); });
    fill_borders(map, 0);
    return map;
}

namespace {

constexpr std::size_t orders =
    5; // 1, cos, sin, cos 2, sin 2 of the azimuth: those of the harmonics of bands 0 to 2

using Orders = std::array<double, orders>;

Orders orders_at(double phi)
{
    return {1.0, std::cos(phi), std::sin(phi), std::cos(2.0 * phi), std::sin(2.0 * phi)};
}

AzimuthOrders orders_of_columns(int width)
{
    AzimuthOrders columns;
    for (int x = 0; x < width; ++x) {
        const Orders at = orders_at(image::column_azimuth(x + 0.5, width));
        for (std::size_t m = 1; m < orders; ++m)
            columns.rows[m - 1].push_back(static_cast<float>(at[m]));
    }
    for (std::vector<float>& row : columns.rows)
        row.resize(row.size() + AzimuthOrders::padding);
    return columns;
}

// The coefficients of the harmonics along a row as sums of the orders, from their values at five azimuths.
std::array<Orders, 9> row_harmonics(double up, double ring)
{
    std::array<Orders, 9> coefficients{};
    for (std::size_t j = 0; j < orders; ++j) {
        const double phi = 2.0 * std::numbers::pi * static_cast<double>(j) / orders;
        const Orders at = orders_at(phi);
        const in_double::Harmonics h = in_double::harmonics({ring * at[1], up, ring * at[2]});
        const double basis[9] = {h.c0, h.c1, h.c2, h.c3, h.c4, h.c5, h.c6, h.c7, h.c8};
        for (std::size_t i = 0; i < 9; ++i)
            for (std::size_t m = 0; m < orders; ++m)
                coefficients[i][m] += (m == 0 ? 1.0 : 2.0) / orders * basis[i] * at[m];
    }
    return coefficients;
}

} // namespace

HarmonicLight project_to_harmonics(const Panorama& panorama)
{
    constexpr int least_width = 256,
                  least_height = 128; // treating a texel as a point has an error of the square of its size
    if (panorama.width < least_width || panorama.height < least_height)
        return project_to_harmonics(at_least(panorama, least_width, least_height));
    const AzimuthOrders columns = orders_of_columns(panorama.width);
    const auto add = [](HarmonicLight a, const HarmonicLight& b) {
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i = 0; i < 9; ++i)
                a[k][i] += b[k][i];
        return a;
    };
    const auto sum_rows = [&](const tbb::blocked_range<int>& rows, HarmonicLight sum) {
        for (int y = rows.begin(); y < rows.end(); ++y) {
            const double theta = (y + 0.5) / panorama.height * std::numbers::pi;
            const std::array<Orders, 3> moments = row_moments(panorama, y, columns);
            const std::array<Orders, 9> harmonics = row_harmonics(std::cos(theta), std::sin(theta));
            const double area = texel_solid_angle(panorama, y);
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t i = 0; i < 9; ++i)
                    for (std::size_t m = 0; m < orders; ++m)
                        sum[k][i] += area * harmonics[i][m] * moments[k][m];
        }
        return sum;
    };
    return tbb::parallel_reduce(tbb::blocked_range<int>(0, panorama.height, 8), HarmonicLight{}, sum_rows,
                                add);
}

} // namespace lambent::environment
