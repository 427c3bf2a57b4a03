#include "bench/cycles/agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lambent::bench {
namespace {

constexpr double bound = 3.0;

using Pictures = std::span<const Taken>;

struct Share {
    int above = 0, all = 0;

    void add(double z)
    {
        above += std::fabs(z) > bound ? 1 : 0;
        ++all;
    }
    double percent() const { return 100.0 * above / all; }
};

Share pixels_above(Pictures a, Pictures b, const Column& column)
{
    Share share;
    for (const std::vector<std::size_t>& sphere : column.spheres)
        for (const std::size_t pixel : sphere)
            share.add(standardised(measured(values_at(a, pixel)), measured(values_at(b, pixel))));
    return share;
}

Share spheres_above(Pictures a, Pictures b, const Column& column)
{
    Share share;
    for (const std::vector<std::size_t>& sphere : column.spheres)
        share.add(standardised(measured(values_over(a, sphere)), measured(values_over(b, sphere))));
    return share;
}

std::vector<std::size_t> all_pixels(const Column& column)
{
    std::vector<std::size_t> pixels;
    for (const std::vector<std::size_t>& sphere : column.spheres)
        pixels.insert(pixels.end(), sphere.begin(), sphere.end());
    return pixels;
}

// RMS over pixels of the difference that noise does not explain, over the mean: 0 where there is none.
double unexplained(Pictures a, Pictures b, const std::vector<std::size_t>& pixels)
{
    double squares = 0.0, mean = 0.0;
    for (const std::size_t pixel : pixels) {
        const Measured x = measured(values_at(a, pixel)), y = measured(values_at(b, pixel));
        squares += (x.mean - y.mean) * (x.mean - y.mean) - x.variance - y.variance;
        mean += y.mean;
    }
    const auto count = static_cast<double>(pixels.size());
    return std::sqrt(std::max(squares, 0.0) / count) / (mean / count);
}

Share halves_above(Pictures pictures, const Column& column)
{
    const std::size_t half = pictures.size() / 2;
    return pixels_above(pictures.first(half), pictures.subspan(half), column);
}

void print_row(const SamePictures& same, const Column& column)
{
    const std::vector<std::size_t> pixels = all_pixels(column);
    const Measured ours = measured(values_over(same.lambent, pixels));
    const Measured theirs = measured(values_over(same.cycles, pixels));
    const double error = std::sqrt(ours.variance + theirs.variance);
    std::printf(
        "| %.3f | %.5f | %+.4f %% | %.4f %% | %+.1f | %.2f %% | %d of %d | %.2f %% | %.2f %% | %.2f %% |\n",
        column.perceptual_roughness, theirs.mean, 100.0 * (ours.mean / theirs.mean - 1.0),
        100.0 * error / theirs.mean, standardised(ours, theirs),
        100.0 * unexplained(same.lambent, same.cycles, pixels),
        spheres_above(same.lambent, same.cycles, column).above, static_cast<int>(column.spheres.size()),
        pixels_above(same.lambent, same.cycles, column).percent(),
        halves_above(same.lambent, column).percent(), halves_above(same.cycles, column).percent());
}

} // namespace

void print_agreement(const SamePictures& same, const std::vector<Column>& columns)
{
    std::puts("| roughness | Cycles' mean | lambent - Cycles | standard error | z | RMS beyond noise | "
              "spheres abs z > 3 | pixels abs z > 3 | lambent's halves | Cycles' halves |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    for (const Column& column : columns)
        print_row(same, column);
    std::fflush(stdout);
}

} // namespace lambent::bench
