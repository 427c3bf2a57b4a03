#include "environment/bake/prefilter_faces.h"

#include "environment/chain/cube_faces.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <mutex>

namespace lambent::environment {
namespace {

constexpr int tile_side = 4, patch_side = 32;

// A part of a face, up to patch_side texels wide and high, from its first texel on.
struct Work {
    const PrefilteredFaces* faces;
    int face, x, y;
};

// The number of every second bit: a coordinate of a Morton code.
int every_second(std::size_t bits)
{
    int value = 0;
    for (int i = 0; i < 8; ++i)
        value |= static_cast<int>(bits >> (2 * i) & 1) << i;
    return value;
}

// Calls visit(x, y, index in the patch) for each texel of it, tile by tile; returns the number of tiles. Tiles are in
// Morton order, so that consecutive ones are close together.
template <class Visit>
std::size_t for_each_texel(const Work& work, int size, const Visit& visit)
{
    constexpr std::size_t all = (patch_side / tile_side) * (patch_side / tile_side);
    std::size_t tiles = 0;
    for (std::size_t i = 0; i < all; ++i) {
        const int left = work.x + tile_side * every_second(i),
                  top = work.y + tile_side * every_second(i >> 1);
        if (left >= size || top >= size)
            continue;
        std::size_t at = PrefilterPatch::tile * tiles++;
        for (int y = top; y < std::min(top + tile_side, size); ++y)
            for (int x = left; x < std::min(left + tile_side, size); ++x)
                visit(x, y, at++);
    }
    return tiles;
}

// The direction of a texel, which may be one of the border.
Direction texel_of(const PrefilteredFaces& faces, int face, int x, int y)
{
    const int border = faces.border, inside = faces.cube.face_size(faces.level) - 2 * border;
    return cube_direction(face, (2.0 * (x - border) + 1.0) / inside - 1.0,
                          (2.0 * (y - border) + 1.0) / inside - 1.0);
}

struct Worker {
    PrefilterPatch patch;
    Prefilter::Scratch scratch;

    void fill(const Work& work)
    {
        image::CubeMap& cube = work.faces->cube;
        const int level = work.faces->level, size = cube.face_size(level);
        const auto direction = [&](int x, int y) { return texel_of(*work.faces, work.face, x, y); };
        // Directions that no texel sets repeat the first, as PrefilterPatch requires.
        const Direction first = direction(work.x, work.y);
        std::fill(std::begin(patch.x), std::end(patch.x), static_cast<float>(first.x));
        std::fill(std::begin(patch.y), std::end(patch.y), static_cast<float>(first.y));
        std::fill(std::begin(patch.z), std::end(patch.z), static_cast<float>(first.z));
        patch.tiles = for_each_texel(work, size, [&](int x, int y, std::size_t at) {
            const Direction d = direction(x, y);
            patch.x[at] = static_cast<float>(d.x);
            patch.y[at] = static_cast<float>(d.y);
            patch.z[at] = static_cast<float>(d.z);
        });
        work.faces->prefilter.fill(patch, scratch);
        for_each_texel(work, size, [&](int x, int y, std::size_t at) {
            float* texel = cube.pixel(level, work.face, x, y);
            texel[0] = patch.dim.r[at], texel[1] = patch.dim.g[at], texel[2] = patch.dim.b[at];
        });
    }
};

std::vector<Work> work_of(const std::vector<PrefilteredFaces>& faces)
{
    std::vector<Work> work;
    for (const PrefilteredFaces& f : faces) {
        const int size = f.cube.face_size(f.level);
        for (int face = 0; face < 6; ++face)
            for (int y = 0; y < size; y += patch_side)
                for (int x = 0; x < size; x += patch_side)
                    work.push_back({&f, face, x, y});
    }
    return work;
}

} // namespace

void prefilter_faces(const std::vector<PrefilteredFaces>& faces, const std::function<void(double)>& report)
{
    const std::vector<Work> work = work_of(faces);
    tbb::enumerable_thread_specific<Worker> workers;
    std::mutex reporting;
    std::size_t done = 0;
    tbb::parallel_for(std::size_t{0}, work.size(), [&](std::size_t i) {
        workers.local().fill(work[i]);
        if (report) {
            const std::lock_guard lock(reporting);
            report(static_cast<double>(++done) / static_cast<double>(work.size()));
        }
    });
}

std::vector<FaceTile> face_tiles(const PrefilteredFaces& faces)
{
    constexpr int side = 8;
    const int size = faces.cube.face_size(faces.level);
    std::vector<FaceTile> tiles;
    for (int face = 0; face < 6; ++face)
        for (int top = 0; top < size; top += side)
            for (int left = 0; left < size; left += side) {
                FaceTile& tile = tiles.emplace_back(FaceTile{face, left, top, {}});
                for (int i = 0; i < side * side; ++i) {
                    const int x = left + i % side, y = top + i / side;
                    const Direction d =
                        x < size && y < size ? texel_of(faces, face, x, y) : texel_of(faces, face, left, top);
                    tile.directions[i][0] = static_cast<float>(d.x);
                    tile.directions[i][1] = static_cast<float>(d.y);
                    tile.directions[i][2] = static_cast<float>(d.z);
                }
            }
    return tiles;
}

} // namespace lambent::environment
