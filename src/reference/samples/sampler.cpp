#include "reference/samples/sampler.h"

namespace lambent::reference {
namespace {

constexpr int bits = 32;
using Directions = std::array<std::uint32_t, bits>;

// A primitive polynomial x^degree + a_1 x^(degree-1) + ... + 1, its inner coefficients as bits, and the first direction
// numbers.
struct Polynomial {
    int degree;
    unsigned inner;
    std::array<std::uint32_t, 3> first;
};

// Direction numbers by the recurrence of Bratley and Fox 1988 (TOMS 659), section 2.
constexpr Directions directions(const Polynomial& p)
{
    Directions v{};
    for (int i = 0; i < bits; ++i) {
        if (i < p.degree) {
            v[static_cast<std::size_t>(i)] = p.first[static_cast<std::size_t>(i)] << (bits - 1 - i);
            continue;
        }
        const std::uint32_t far = v[static_cast<std::size_t>(i - p.degree)];
        std::uint32_t value = far ^ (far >> p.degree);
        for (int k = 1; k < p.degree; ++k)
            if (p.inner >> (p.degree - 1 - k) & 1u)
                value ^= v[static_cast<std::size_t>(i - k)];
        v[static_cast<std::size_t>(i)] = value;
    }
    return v;
}

constexpr Directions van_der_corput()
{
    Directions v{};
    for (int i = 0; i < bits; ++i)
        v[static_cast<std::size_t>(i)] = 1u << (bits - 1 - i);
    return v;
}

// Dimension 1, and dimensions 2 to 4 of Joe and Kuo's new-joe-kuo-6.
constexpr std::array<Directions, 4> tables = {van_der_corput(), directions({1, 0, {1, 0, 0}}),
                                              directions({2, 1, {1, 3, 0}}), directions({3, 1, {1, 3, 1}})};

// Contribution of each byte of an index to the point: four lookups instead of 32 tests of bits.
using Point = std::array<std::uint32_t, 4>;
using ByteTables = std::array<std::array<Point, 256>, 4>;

constexpr ByteTables byte_tables()
{
    ByteTables result{};
    for (std::size_t byte = 0; byte < 4; ++byte)
        for (std::size_t value = 0; value < 256; ++value)
            for (std::size_t bit = 0; bit < 8; ++bit)
                for (std::size_t d = 0; d < 4; ++d)
                    if (value >> bit & 1u)
                        result[byte][value][d] ^= tables[d][8 * byte + bit];
    return result;
}

constexpr ByteTables by_byte = byte_tables();

constexpr std::uint32_t reversed(std::uint32_t x)
{
    x = (x >> 16) | (x << 16);
    x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
    x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
    return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
}

} // namespace

std::array<std::uint32_t, 4> sobol(std::uint32_t index)
{
    Point point{};
    for (std::size_t byte = 0; byte < 4; ++byte)
        for (std::size_t d = 0; d < 4; ++d)
            point[d] ^= by_byte[byte][index >> (8 * byte) & 255u][d];
    return point;
}

std::uint32_t owen_scrambled(std::uint32_t fraction, std::uint32_t seed)
{
    // A product with an even number changes a bit only by less significant ones. Because the bits are reversed, each
    // bit of the fraction depends on more significant ones alone.
    std::uint32_t x = reversed(fraction) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reversed(x);
}

std::array<double, 4> SampleSequence::next4()
{
    const std::uint32_t seed = hashed(sequence_, ++dimension_);
    // The order of points is scrambled too, because otherwise all calls would use the same points in the same order.
    const std::uint32_t shuffled = owen_scrambled(index_, seed);
    const std::array<std::uint32_t, 4> point = sobol(shuffled);
    std::array<double, 4> u;
    for (std::uint32_t d = 0; d < 4; ++d)
        u[d] = owen_scrambled(point[d], hashed(seed, d + 1)) * 0x1p-32;
    return u;
}

double SampleSequence::random()
{
    return hashed(hashed(sequence_, 0x68bc21ebu + ++drawn_), index_) * 0x1p-32;
}

} // namespace lambent::reference
