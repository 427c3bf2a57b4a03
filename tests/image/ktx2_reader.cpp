#include "tests/image/cube_reader.h"

#include <algorithm>
#include <cstring>

#ifdef LAMBENT_ZSTD
#include <zstd.h>
#endif

namespace lambent::test {
namespace {

Storage storage_of(unsigned vk_format)
{
    switch (vk_format) {
    case 97:
        return Storage::halfs;
    case 109:
        return Storage::floats;
    case 123:
        return Storage::shared_exponent;
    default:
        throw std::runtime_error("unknown VkFormat");
    }
}

void require_zeros(const Bytes& file, std::uint64_t from, std::uint64_t to)
{
    for (std::uint64_t at = from; at < to; ++at)
        require(number_at(file, at, 1) == 0, "padding is 0");
}

void read_descriptor(const Bytes& file, std::uint64_t at, std::uint64_t length, CubeFile& cube)
{
    require(length >= 28 && word_at(file, at) == length, "dfdTotalSize");
    require(word_at(file, at + 4) == 0, "Khronos' basic block");
    require(number_at(file, at + 8, 2) == 2, "version 1.3");
    require(number_at(file, at + 10, 2) == length - 4, "the block is all there is");
    cube.model = static_cast<unsigned>(number_at(file, at + 12, 1));
    cube.primaries = static_cast<unsigned>(number_at(file, at + 13, 1));
    cube.transfer = static_cast<unsigned>(number_at(file, at + 14, 1));
    cube.flags = static_cast<unsigned>(number_at(file, at + 15, 1));
    require(word_at(file, at + 16) == 0, "a block is one texel");
    cube.plane_bytes = static_cast<unsigned>(number_at(file, at + 20, 1));
    require_zeros(file, at + 21, at + 28);
    require((length - 28) % 16 == 0, "a whole number of samples");
    for (std::uint64_t sample = at + 28; sample < at + length; sample += 16) {
        const auto byte = [&](std::uint64_t i) {
            return static_cast<unsigned>(number_at(file, sample + i, 1));
        };
        cube.samples.push_back({static_cast<unsigned>(number_at(file, sample, 2)),
                                byte(2) + 1,
                                byte(3) & 15,
                                byte(3) & ~15u,
                                word_at(file, sample + 8),
                                word_at(file, sample + 12),
                                {byte(4), byte(5), byte(6), byte(7)}});
    }
}

void read_metadata(const Bytes& file, std::uint64_t at, std::uint64_t length, CubeFile& cube)
{
    const std::uint64_t end = at + length;
    std::string last;
    while (at < end) {
        require(at % 4 == 0, "pairs are aligned");
        const unsigned count = word_at(file, at);
        require(count >= 2 && at + 4 + count <= end, "keyAndValueByteLength");
        const auto begin = file.begin() + static_cast<std::ptrdiff_t>(at + 4);
        const std::string pair(begin, begin + count);
        const std::size_t zero = pair.find('\0');
        require(zero != std::string::npos && zero > 0, "a key ends with a zero");
        const std::string key = pair.substr(0, zero);
        require(last.compare(key) < 0, "keys are sorted and different");
        cube.metadata[key] = pair.substr(zero + 1);
        last = key;
        at += 4 + count;
        require_zeros(file, at, (at + 3) / 4 * 4);
        at = (at + 3) / 4 * 4;
    }
    require(at == end, "kvdByteLength");
}

Bytes inflated(const Bytes& packed, std::uint64_t length)
{
    Bytes bytes(length);
#ifdef LAMBENT_ZSTD
    require(ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size()) == length,
            "a level is one Zstandard frame of the length that was promised");
#else
    require(packed.empty(), "no Zstandard where there is none");
#endif
    return bytes;
}

void read_level(const Bytes& file, unsigned level, CubeFile& cube)
{
    const std::uint64_t entry = 80 + 24 * std::uint64_t{level};
    const std::uint64_t offset = number_at(file, entry, 8), length = number_at(file, entry + 8, 8);
    const std::uint64_t whole = number_at(file, entry + 16, 8);
    const unsigned size = std::max(1u, cube.size >> level);
    const Storage storage = storage_of(cube.format);
    const std::uint64_t face_bytes = std::uint64_t{size} * size * storage_bytes(storage);
    require(whole == 6 * face_bytes, "uncompressedByteLength");
    require(offset + length <= file.size(), "levels are in the file");
    cube.offsets.push_back(offset);
    cube.lengths.push_back(length);
    const auto begin = file.begin() + static_cast<std::ptrdiff_t>(offset);
    Bytes bytes(begin, begin + static_cast<std::ptrdiff_t>(length));
    if (cube.scheme == 2) {
        bytes = inflated(bytes, whole);
    } else {
        require(length == whole, "byteLength");
        require(offset % storage_bytes(storage) == 0 && offset % 4 == 0, "levels are aligned");
    }
    for (unsigned face = 0; face < 6; ++face)
        cube.levels[level][face] = face_at(bytes, face * face_bytes, size, storage);
}

// From the smallest level to the largest, with no more padding between them than alignment needs.
void check_order(const Bytes& file, std::uint64_t end_of_head, const CubeFile& cube)
{
    const std::uint64_t alignment = cube.scheme == 0 ? storage_bytes(storage_of(cube.format)) : 1;
    std::uint64_t at = end_of_head;
    for (std::size_t level = cube.levels.size(); level-- > 0;) {
        require(cube.offsets[level] == (at + alignment - 1) / alignment * alignment, "byteOffset");
        require_zeros(file, at, cube.offsets[level]);
        at = cube.offsets[level] + cube.lengths[level];
    }
    require(at == file.size(), "nothing behind the last level");
}

} // namespace

CubeFile read_ktx2(const Bytes& file)
{
    require(file.size() > 80 && std::memcmp(file.data(), "\xABKTX 20\xBB\r\n\x1A\n", 12) == 0, "identifier");
    CubeFile cube;
    cube.format = word_at(file, 12);
    cube.type_size = word_at(file, 16);
    cube.size = word_at(file, 20);
    require(word_at(file, 24) == cube.size, "as high as wide");
    require(word_at(file, 28) == 0, "pixelDepth");
    require(word_at(file, 32) == 0, "layerCount");
    require(word_at(file, 36) == 6, "faceCount");
    const unsigned levels = word_at(file, 40);
    cube.scheme = word_at(file, 44);
    require(cube.scheme == 0 || cube.scheme == 2, "supercompressionScheme");
    const unsigned descriptor = word_at(file, 48), descriptor_bytes = word_at(file, 52);
    const unsigned pairs = word_at(file, 56), pairs_bytes = word_at(file, 60);
    require(number_at(file, 64, 8) == 0 && number_at(file, 72, 8) == 0, "no supercompressionGlobalData");
    require(descriptor == 80 + 24 * levels, "the descriptor follows the index");
    require(pairs == descriptor + descriptor_bytes, "the pairs follow the descriptor");
    read_descriptor(file, descriptor, descriptor_bytes, cube);
    read_metadata(file, pairs, pairs_bytes, cube);
    cube.levels.resize(levels);
    for (unsigned level = 0; level < levels; ++level)
        read_level(file, level, cube);
    check_order(file, pairs + pairs_bytes, cube);
    return cube;
}

} // namespace lambent::test
