// Points that are spread evenly: the properties that define them, counted.
#include "reference/samples/sampler.h"
#include "tests/support/chi_square.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace lambent::reference {
namespace {

using Points = std::vector<std::array<double, 4>>;
constexpr int most_bits = 10;

// Each of 2^m equal intervals holds exactly one of 2^m points.
void expect_stratified(const Points& points, std::size_t dimension)
{
    std::set<int> cells;
    for (const auto& p : points)
        cells.insert(static_cast<int>(p[dimension] * static_cast<double>(points.size())));
    EXPECT_EQ(cells.size(), points.size()) << "dimension " << dimension;
}

// Every way to divide the square into 2^m equal boxes has one point in each. [Niederreiter 1987, (0, m, 2)-net]
void expect_net(const Points& points, int m)
{
    for (int across = 0; across <= m; ++across) {
        std::set<std::pair<int, int>> boxes;
        for (const auto& p : points)
            boxes.insert(
                {static_cast<int>(std::ldexp(p[0], across)), static_cast<int>(std::ldexp(p[1], m - across))});
        EXPECT_EQ(boxes.size(), points.size()) << "2^" << across << " columns of 2^" << m << " boxes";
    }
}

void expect_spread(const std::function<std::array<double, 4>(std::uint32_t)>& point)
{
    for (int m = 0; m <= most_bits; ++m) {
        Points points;
        for (std::uint32_t i = 0; i < 1u << m; ++i)
            points.push_back(point(i));
        for (std::size_t d = 0; d < 4; ++d)
            expect_stratified(points, d);
        expect_net(points, m);
    }
}

TEST(ReferenceSampler, SobolPointsAreNets)
{
    for (const std::uint32_t first : {0u, 1u << 10, 5u << 20, 0xfffffc00u})
        expect_spread([&](std::uint32_t i) {
            const auto p = sobol(first + i);
            return std::array{p[0] * 0x1p-32, p[1] * 0x1p-32, p[2] * 0x1p-32, p[3] * 0x1p-32};
        });
}

// Joe and Kuo's published list, new-joe-kuo-6: the first points in natural order.
TEST(ReferenceSampler, SobolPointsAreThePublishedOnes)
{
    const double expected[8][4] = {{0.0, 0.0, 0.0, 0.0},         {0.5, 0.5, 0.5, 0.5},
                                   {0.25, 0.75, 0.75, 0.75},     {0.75, 0.25, 0.25, 0.25},
                                   {0.125, 0.625, 0.375, 0.125}, {0.625, 0.125, 0.875, 0.625},
                                   {0.375, 0.375, 0.625, 0.875}, {0.875, 0.875, 0.125, 0.375}};
    for (std::uint32_t i = 0; i < 8; ++i)
        for (std::size_t d = 0; d < 4; ++d)
            EXPECT_EQ(sobol(i)[d] * 0x1p-32, expected[i][d]) << i << ' ' << d;
}

TEST(ReferenceSampler, ScramblingKeepsThem)
{
    for (const std::uint32_t seed : {0u, 1u, 12345u, 0xffffffffu})
        expect_spread([&](std::uint32_t i) {
            const auto p = sobol(i);
            std::array<double, 4> u;
            for (std::uint32_t d = 0; d < 4; ++d)
                u[d] = owen_scrambled(p[d], hashed(seed, d)) * 0x1p-32;
            return u;
        });
}

// Nested: numbers that agree in their first k bits and differ in the next do so after it, too.
TEST(ReferenceSampler, ScramblingIsNested)
{
    for (std::uint32_t seed = 0; seed < 50; ++seed)
        for (int bit = 0; bit < 32; ++bit) {
            const std::uint32_t a = hashed(seed, 77), b = a ^ (0x80000000u >> bit);
            const std::uint32_t differ =
                owen_scrambled(a, hashed(seed, 3)) ^ owen_scrambled(b, hashed(seed, 3));
            ASSERT_EQ(differ >> (31 - bit), 1u);
        }
}

TEST(ReferenceSampler, SamplesOfASequenceAreNetsInEveryCall)
{
    for (const std::uint32_t sequence : {0u, 1u, 999u, 0xdeadbeefu})
        for (int call = 0; call < 4; ++call)
            expect_spread([&](std::uint32_t i) {
                SampleSequence sampler(sequence, i);
                for (int skipped = 0; skipped < call; ++skipped)
                    sampler.next4();
                return sampler.next4();
            });
}

// Of 16 x 16 boxes that of a pair of numbers.
std::size_t box(double a, double b)
{
    return 16 * test::part_of(a, 16) + test::part_of(b, 16);
}

// One number of each of many sequences, pairs of dimensions: 16 x 16 boxes.
TEST(ReferenceSampler, SequencesAreUniformAndIndependent)
{
    constexpr int count = 100000;
    for (std::uint32_t index : {0u, 5u})
        for (std::size_t d = 0; d < 4; ++d) {
            std::vector<double> own(256, 0.0), neighbours(256, 0.0), calls(256, 0.0);
            for (std::uint32_t s = 0; s < count; ++s) {
                SampleSequence one(2 * s, index), other(2 * s + 1, index);
                const auto a = one.next4(), b = other.next4(), c = one.next4();
                ++own[box(a[d], a[(d + 1) % 4])];
                ++neighbours[box(a[d], b[d])];
                ++calls[box(a[d], c[d])];
            }
            EXPECT_TRUE(test::follows_evenly(own)) << d;
            EXPECT_TRUE(test::follows_evenly(neighbours)) << d;
            EXPECT_TRUE(test::follows_evenly(calls)) << d;
        }
}

TEST(ReferenceSampler, RandomIsUniformAndIndependent)
{
    std::vector<double> draws(256, 0.0), indices(256, 0.0), sequences(256, 0.0);
    constexpr int count = 100000;
    for (std::uint32_t i = 0; i < count; ++i) {
        SampleSequence one(7, 2 * i), next(7, 2 * i + 1), of_sequence(2 * i, 3), of_next(2 * i + 1, 3);
        const double first = one.random(), second = one.random();
        ++draws[box(first, second)];
        ++indices[box(first, next.random())];
        ++sequences[box(of_sequence.random(), of_next.random())];
        ASSERT_TRUE(first >= 0.0 && first < 1.0);
    }
    EXPECT_TRUE(test::follows_evenly(draws));
    EXPECT_TRUE(test::follows_evenly(indices));
    EXPECT_TRUE(test::follows_evenly(sequences));
}

} // namespace
} // namespace lambent::reference
