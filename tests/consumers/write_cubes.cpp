// Writes the cube maps that check.mjs reads: write_cubes FOLDER. Texel (x, y) of a face of a level is
// (8 y + x + 1, face + 1, level + 1), which every format holds exactly.
#include "image/cube/cube_files.h"

#include <cstdio>
#include <exception>

namespace {

using namespace lambent::image;

CubeMap numbered(int size)
{
    CubeMap map = make_cube_map(size, full_levels(size));
    for (int level = 0; level < map.levels; ++level)
        for (int face = 0; face < 6; ++face)
            for (int y = 0; y < map.face_size(level); ++y)
                for (int x = 0; x < map.face_size(level); ++x) {
                    float* const texel = map.pixel(level, face, x, y);
                    texel[0] = static_cast<float>(8 * y + x + 1);
                    texel[1] = static_cast<float>(face + 1);
                    texel[2] = static_cast<float>(level + 1);
                }
    return map;
}

void write_all(const std::filesystem::path& folder)
{
    const CubeMap map = numbered(8);
    const std::pair<const char*, TexelFormat> formats[] = {
        {"half4", TexelFormat::half4}, {"float4", TexelFormat::float4}, {"rgb9e5", TexelFormat::rgb9e5}};
    for (const auto& [name, format] : formats) {
        const std::string start = (folder / name).string();
        write_dds(map, format, start + ".dds");
        write_ktx2(map, {format, false, {{"lambent.test", "an odd one"}}}, start + ".ktx2");
        if (can_write_zstd())
            write_ktx2(map, {format, true, {}}, start + ".zstd.ktx2");
    }
}

} // namespace

int main(int count, char** words)
{
    if (count != 2) {
        std::fputs("usage: write_cubes FOLDER\n", stderr);
        return 2;
    }
    try {
        write_all(words[1]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "write_cubes: %s\n", error.what());
        return 1;
    }
}
