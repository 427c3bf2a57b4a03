// The probes over whole batches of points, in each way in which the text compiles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent::test {

// What a probe takes and gives for each point.
constexpr size_t probe_inputs = 8, probe_outputs = 4;

// Number k of point i is at k * points + i. points is a multiple of 64, so that no batch is broken.
struct Arguments {
    size_t points = 0;
    std::vector<float> numbers;
};

struct Probe {
    int number;
    const char* name;
    double lanes_absolute, lanes_relative;
    double glsl_absolute, glsl_relative;

    double lanes_bound(double result) const;
    double glsl_bound(double result) const;
};

// In the order of their numbers, which count from 0.
const std::vector<Probe>& all_probes();

// Results of one probe, laid out as the arguments are.
std::vector<double> probe_in_double(int number, const Arguments& arguments);

// The same over the lanes of the Highway target that is chosen now.
std::vector<float> probe_over_lanes(int number, const Arguments& arguments);

} // namespace lambent::test
