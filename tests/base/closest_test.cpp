#include "base/closest.h"

#include <gtest/gtest.h>

#include <vector>

namespace lambent {
namespace {

// Distances by hand.
TEST(Closest, EditsAreCounted)
{
    EXPECT_EQ(edit_distance("", ""), 0u);
    EXPECT_EQ(edit_distance("", "abc"), 3u);
    EXPECT_EQ(edit_distance("abc", ""), 3u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u); // k-s, e-i, +g
    EXPECT_EQ(edit_distance("sphere", "spehre"), 1u);  // one exchange
    EXPECT_EQ(edit_distance("ca", "abc"), 3u);         // an exchanged pair is not edited again
    EXPECT_EQ(edit_distance("exposure", "exposre"), 1u);
}

TEST(Closest, ItIsSymmetric)
{
    const std::vector<std::string> words = {"", "a", "studio", "stduio", "sky", "kitchen", "furnace"};
    for (const std::string& a : words)
        for (const std::string& b : words)
            EXPECT_EQ(edit_distance(a, b), edit_distance(b, a)) << a << " " << b;
}

TEST(Closest, TheNearestWordIsMeant)
{
    const std::vector<std::string> words = {"sphere", "teapot", "plane", "report", "grid"};
    EXPECT_EQ(closest("spehre", words), "sphere");
    EXPECT_EQ(closest("plain", words), "plane"); // 2 of 5
    EXPECT_EQ(closest("plume", words), "plane"); // 2 of 5
    EXPECT_EQ(closest("spine", words), "");      // 3 of 6
    EXPECT_EQ(closest("tepot", words), "teapot");
    EXPECT_EQ(closest("gird", words), "grid");
    EXPECT_EQ(closest("reprot", words), "report");
    EXPECT_EQ(did_you_mean("reprot", words), "; did you mean 'report'?");
}

TEST(Closest, WhatIsFarFromEverythingIsNotGuessed)
{
    const std::vector<std::string> words = {"--aa", "sky", "render"};
    for (const char* word : {"", "x", "model.glb", "zzzzzz", "s"})
        EXPECT_EQ(closest(word, words), "") << word;
    EXPECT_EQ(did_you_mean(std::string(100000, 'a'), words), "");
}

} // namespace
} // namespace lambent
