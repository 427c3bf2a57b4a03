#include "image/cube/cube_map.h"

#include "image/refuse.h"

namespace lambent::image {
namespace {

void check_shape(int size, int levels)
{
    if (size < 1 || size > max_side)
        throw Error(Failure::usage, text("a cube map has faces of 1 to ", max_side, " texels, not ", size));
    if (levels < 1 || levels > full_levels(size))
        throw Error(Failure::usage, text("a cube map of size ", size, " has 1 to ", full_levels(size),
                                         " levels, not ", levels));
}

// Column and row of each face in the cross.
constexpr int cross_positions[6][2] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}};

} // namespace

CubeMap make_cube_map(int size, int levels)
{
    check_shape(size, levels);
    CubeMap map{size, levels, {}};
    map.values.resize(map.level_start(levels));
    return map;
}

void check_cube_map(const CubeMap& map)
{
    check_shape(map.size, map.levels);
    if (map.values.size() != map.level_start(map.levels))
        throw Error(Failure::usage,
                    text("a cube map of size ", map.size, " with ", map.levels, " levels has ",
                         map.level_start(map.levels), " values, not ", map.values.size()));
}

CubeMap mirrored(const CubeMap& map)
{
    check_cube_map(map);
    CubeMap turned = map;
    for (int level = 0; level < map.levels; ++level)
        for (int face = 0; face < 6; ++face) {
            const int from = face < 2 ? 1 - face : face;
            const int last = map.face_size(level) - 1;
            for (int y = 0; y <= last; ++y)
                for (int x = 0; x <= last; ++x)
                    std::copy_n(map.pixel(level, from, last - x, y), 3, turned.pixel(level, face, x, y));
        }
    return turned;
}

RadianceImage face_image(const CubeMap& map, int level, int face)
{
    const std::span<const float> values = map.face(level, face);
    return {map.face_size(level), map.face_size(level), 3, {values.begin(), values.end()}};
}

RadianceImage cross_image(const CubeMap& map, int level)
{
    const int size = map.face_size(level);
    RadianceImage cross = black_image(4 * size, 3 * size);
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            std::copy_n(map.pixel(level, face, 0, y), 3 * size,
                        cross.pixel(cross_positions[face][0] * size, cross_positions[face][1] * size + y));
    return cross;
}

} // namespace lambent::image
