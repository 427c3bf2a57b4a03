// Points at which the three compilations of the text are compared, and the comparison.
#pragma once

#include "tests/equations/probes/probes.h"

#include <string>

namespace lambent::test {

// Seeded points in [0, 1), rounded to float first so that all start alike: mostly uniform, some gathered at
// the ends.
Arguments random_arguments();

// All combinations of 0, 1/2 and the float below 1.
Arguments corner_arguments();

// The largest difference of a probe, in units of its bound: above 1 is a failure.
struct Worst {
    double ratio = 0.0;
    double difference = 0.0;
    double wanted = 0.0;
    size_t output = 0;
    size_t point = 0;
};

using Bound = double (Probe::*)(double) const;

// results: as probe_in_double's. A result that is not finite has an infinite ratio.
Worst compare(const Probe& probe, Bound bound, const std::vector<double>& wanted, const float* results,
              size_t points);

// One line for each probe: name, ratio, difference, where.
std::string describe(const Probe& probe, const Worst& worst, const Arguments& arguments);

} // namespace lambent::test
