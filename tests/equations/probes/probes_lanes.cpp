#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/equations/probes/probes_lanes.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"
#include "tests/equations/probes/probes.h"

HWY_BEFORE_NAMESPACE();
namespace lambent::test::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"
#include "tests/equations/probes/probes.glsl"
#include "tests/equations/probes/probes_shading.glsl"

// n numbers of each input from `from` on, n numbers of each output to `to` on; n is a multiple of the lanes.
void run(int number, size_t n, const float* from, float* to)
{
    for (size_t i = 0; i < n; i += lane_count, from += lane_count, to += lane_count) {
        const Inputs inputs = {load(from),         load(from + n),     load(from + 2 * n),
                               load(from + 3 * n), load(from + 4 * n), load(from + 5 * n),
                               load(from + 6 * n), load(from + 7 * n)};
        const Outputs o = probe(number, inputs);
        store(o.x, to);
        store(o.y, to + n);
        store(o.z, to + 2 * n);
        store(o.w, to + 3 * n);
    }
}

} // namespace
} // namespace lambent::test::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::test {

HWY_EXPORT(run);

std::vector<float> probe_over_lanes(int number, const Arguments& arguments)
{
    std::vector<float> results(probe_outputs * arguments.points);
    HWY_DYNAMIC_DISPATCH(run)(number, arguments.points, arguments.numbers.data(), results.data());
    return results;
}

} // namespace lambent::test
#endif
