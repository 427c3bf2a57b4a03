// Cube map files read by their specifications alone, independently of the library's writers. What breaks a
// rule is a std::runtime_error that says which.
#pragma once

#include "tests/image/bytes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace lambent::test {

using Texel = std::array<double, 4>;

/// Texels of one face of one level, row by row.
using Face = std::vector<Texel>;

/// One of the samples of a KTX 2 data format descriptor.
struct DescribedSample {
    unsigned bit_offset, bit_length, channel, qualifiers;
    std::uint32_t lower, upper;
    std::array<unsigned, 4> position;
};

struct CubeFile {
    unsigned size = 0, format = 0;
    std::vector<std::array<Face, 6>> levels;

    // Of KTX 2 only.
    unsigned type_size = 0, scheme = 0;
    unsigned model = 0, primaries = 0, transfer = 0, flags = 0, plane_bytes = 0;
    std::vector<DescribedSample> samples;
    std::map<std::string, std::string> metadata; ///< values with their final zero
    std::vector<std::uint64_t> offsets, lengths; ///< of the levels
};

CubeFile read_ktx2(const Bytes& file);
CubeFile read_dds(const Bytes& file);

inline void require(bool condition, const std::string& rule)
{
    if (!condition)
        throw std::runtime_error("broken: " + rule);
}

/// A little-endian number of `count` bytes.
inline std::uint64_t number_at(const Bytes& file, std::uint64_t at, int count)
{
    require(at + static_cast<std::uint64_t>(count) <= file.size(),
            "the file goes on to the end of its parts");
    std::uint64_t number = 0;
    for (int i = count; i-- > 0;)
        number = number * 256 + file[at + static_cast<std::uint64_t>(i)];
    return number;
}

inline unsigned word_at(const Bytes& file, std::uint64_t at)
{
    return static_cast<unsigned>(number_at(file, at, 4));
}

/// How texels are stored, under a name that is neither Vulkan's nor Direct3D's.
enum class Storage { halfs, floats, shared_exponent };

inline unsigned storage_bytes(Storage storage)
{
    return storage == Storage::halfs ? 8 : storage == Storage::floats ? 16 : 4;
}

inline double half_at(const Bytes& file, std::uint64_t at)
{
    const auto code = static_cast<int>(number_at(file, at, 2));
    const int exponent = code / 1024 % 32, mantissa = code % 1024;
    require(exponent < 31, "no infinity and no NaN");
    const double size =
        exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25);
    return code >= 32768 ? -size : size;
}

inline double float_at(const Bytes& file, std::uint64_t at)
{
    const unsigned word = word_at(file, at);
    float value;
    std::memcpy(&value, &word, sizeof value);
    return value;
}

inline Texel texel_at(const Bytes& file, std::uint64_t at, Storage storage)
{
    Texel texel{0, 0, 0, 1};
    const unsigned word = word_at(file, at);
    for (unsigned c = 0; c < 4; ++c) {
        if (storage == Storage::halfs)
            texel[c] = half_at(file, at + 2 * c);
        else if (storage == Storage::floats)
            texel[c] = float_at(file, at + 4 * c);
        else if (c < 3)
            texel[c] =
                std::ldexp(static_cast<double>(word >> 9 * c & 511), static_cast<int>(word >> 27) - 24);
    }
    return texel;
}

inline Face face_at(const Bytes& file, std::uint64_t at, unsigned size, Storage storage)
{
    Face face;
    for (std::uint64_t i = 0; i < std::uint64_t{size} * size; ++i)
        face.push_back(texel_at(file, at + i * storage_bytes(storage), storage));
    return face;
}

} // namespace lambent::test
