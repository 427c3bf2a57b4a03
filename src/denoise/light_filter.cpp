#include "denoise/light_filter.h"

#include "base/error.h"
#include "denoise/tile_stream.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <string>

namespace lambent::denoise {
namespace {

void check(const Plane& plane, std::size_t size, const char* name)
{
    if (plane.size() != size)
        throw Error(Failure::usage, std::string("denoise: ") + name + " has " + std::to_string(plane.size()) +
                                        " values, the picture " + std::to_string(size) + " pixels");
}

void check(const Rgb& planes, std::size_t size, const char* name)
{
    for (const Plane& plane : planes)
        check(plane, size, name);
}

void check(const Light& light, std::size_t size)
{
    check(light.exact, size, "the exact light");
    if (!light.albedo[0].empty() || !light.albedo[1].empty() || !light.albedo[2].empty())
        check(light.albedo, size, "the albedo");
    for (const Half& half : light.halves) {
        check(half.unshadowed, size, "the unshadowed light");
        check(half.found, size, "the light found");
    }
}

std::size_t check(const Picture& picture)
{
    if (picture.width < 0 || picture.height < 0)
        throw Error(Failure::usage, "denoise: the picture's size is negative");
    const std::size_t size =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    const Guides& guides = picture.guides;
    check(guides.coverage, size, "the coverage");
    check(guides.normal, size, "the normal");
    check(guides.depth, size, "the depth");
    check(guides.alpha, size, "the lobes' width");
    check(guides.metalness, size, "the metalness");
    check(picture.count, size, "the number of samples");
    check(picture.diffuse, size);
    check(picture.specular, size);
    return size;
}

FilteredLight empty_result(std::size_t size)
{
    FilteredLight result;
    for (std::size_t c = 0; c < 3; ++c) {
        result.light[c].resize(size);
        result.gap[c].resize(size);
    }
    return result;
}

// Strips of at most 640 columns, cut into bands so that every thread has some tiles; the fewer, the less is computed
// twice around them.
std::vector<Tile> tiles_of(int width, int height)
{
    constexpr int widest = 640, least_rows = 64;
    const int strips = (width + widest - 1) / widest;
    const int wanted = 4 * tbb::this_task_arena::max_concurrency();
    const int bands =
        std::clamp((wanted + strips - 1) / std::max(strips, 1), 1, std::max(height / least_rows, 1));
    std::vector<Tile> tiles;
    for (int j = 0; j < bands; ++j)
        for (int i = 0; i < strips; ++i)
            tiles.push_back(
                {width * i / strips, height * j / bands, width * (i + 1) / strips, height * (j + 1) / bands});
    return tiles;
}

} // namespace

void filter_light(const Picture& picture, const Settings& settings, const TakeRow& take)
{
    if (check(picture) == 0)
        return;
    const ControlShares diffuse(picture, picture.diffuse), specular(picture, picture.specular);
    const std::vector<Tile> tiles = tiles_of(picture.width, picture.height);
    tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t i) {
        filter_tile({picture, picture.diffuse, diffuse, false, settings, take}, tiles[i]);
        filter_tile({picture, picture.specular, specular, true, settings, take}, tiles[i]);
    });
}

Filtered filter_light(const Picture& picture, const Settings& settings)
{
    const std::size_t size = check(picture);
    Filtered result{empty_result(size), empty_result(size)};
    filter_light(picture, settings, [&](const FilteredRow& row) {
        FilteredLight& to = row.specular ? result.specular : result.diffuse;
        const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(row.y) * picture.width + row.x;
        for (std::size_t c = 0; c < 3; ++c) {
            std::copy_n(row.light[c], row.columns, to.light[c].begin() + first);
            std::copy_n(row.gap[c], row.columns, to.gap[c].begin() + first);
        }
    });
    return result;
}

} // namespace lambent::denoise
