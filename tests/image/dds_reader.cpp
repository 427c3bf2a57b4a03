#include "tests/image/cube_reader.h"

#include <algorithm>

namespace lambent::test {
namespace {

Storage storage_of(unsigned dxgi)
{
    switch (dxgi) {
    case 10:
        return Storage::halfs;
    case 2:
        return Storage::floats;
    case 67:
        return Storage::shared_exponent;
    default:
        throw std::runtime_error("unknown DXGI_FORMAT");
    }
}

// DDS_HEADER: every field has its place from the start of the file.
void check_header(const Bytes& file, unsigned size, unsigned levels)
{
    require(word_at(file, 0) == 0x20534444, "magic");
    require(word_at(file, 4) == 124, "dwSize");
    const unsigned flags = word_at(file, 8), caps = word_at(file, 108);
    require((flags & 0x1007) == 0x1007, "caps, height, width and pixel format are valid");
    require(((flags & 0x20000) != 0) == (levels > 1),
            "the number of levels is valid where there are several");
    require(word_at(file, 16) == size, "as wide as high");
    require(word_at(file, 24) <= 1, "no depth");
    require(word_at(file, 76) == 32, "size of the pixel format");
    require(word_at(file, 80) == 4, "the pixel format is a FourCC");
    require(word_at(file, 84) == 0x30315844, "FourCC DX10");
    require((caps & 0x1008) == 0x1008, "a complex texture");
    require(((caps & 0x400000) != 0) == (levels > 1), "mipmaps where there are several");
    require(word_at(file, 112) == 0xfe00, "a cube map with all six faces");
    for (unsigned at : {32, 36, 40, 44, 48, 52, 56, 60, 64, 68, 72, 88, 92, 96, 100, 104, 116, 120, 124})
        require(word_at(file, at) == 0, "what is reserved or not used is 0");
}

} // namespace

CubeFile read_dds(const Bytes& file)
{
    CubeFile cube;
    cube.size = word_at(file, 12);
    const unsigned levels = word_at(file, 28);
    check_header(file, cube.size, levels);
    cube.format = word_at(file, 128);
    require(word_at(file, 132) == 3, "resourceDimension TEXTURE2D");
    require(word_at(file, 136) == 4, "miscFlag TEXTURECUBE");
    require(word_at(file, 140) == 1, "one cube");
    require(word_at(file, 144) == 3, "opaque");
    const Storage storage = storage_of(cube.format);
    require(word_at(file, 20) == cube.size * storage_bytes(storage), "pitch");
    cube.levels.resize(levels);
    std::uint64_t at = 148;
    for (unsigned face = 0; face < 6; ++face)
        for (unsigned level = 0; level < levels; ++level) {
            const unsigned size = std::max(1u, cube.size >> level);
            cube.levels[level][face] = face_at(file, at, size, storage);
            at += std::uint64_t{size} * size * storage_bytes(storage);
        }
    require(at == file.size(), "nothing behind the last texel");
    return cube;
}

} // namespace lambent::test
