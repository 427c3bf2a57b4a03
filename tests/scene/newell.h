// The teapot's data in the form in which it is handed down, typed in from published listings that agree with
// each other: 306 points and, for each of the 32 patches, sixteen of them counted from 1.
#pragma once

#include <array>

namespace lambent::scene::test {

extern const std::array<std::array<double, 3>, 306> newell_points;
extern const std::array<std::array<int, 16>, 32> newell_patches;

} // namespace lambent::scene::test
