#include "equations/in_double.h"
#include "tests/equations/probes/probes.h"

#include <cmath>

namespace lambent::in_double {
namespace {

#include "tests/equations/probes/probes.glsl"
#include "tests/equations/probes/probes_shading.glsl"

} // namespace
} // namespace lambent::in_double

namespace lambent::test {

double Probe::lanes_bound(double result) const
{
    return lanes_absolute + lanes_relative * std::abs(result);
}

double Probe::glsl_bound(double result) const
{
    return glsl_absolute + glsl_relative * std::abs(result);
}

const std::vector<Probe>& all_probes()
{
    static const std::vector<Probe> probes = {
#define PROBE(number, name, ...) {number, #name, __VA_ARGS__},
#include "tests/equations/probes/probes_list.h"
#undef PROBE
    };
    return probes;
}

std::vector<double> probe_in_double(int number, const Arguments& arguments)
{
    const size_t n = arguments.points;
    const float* from = arguments.numbers.data();
    std::vector<double> results(probe_outputs * n);
    for (size_t i = 0; i < n; i++, from++) {
        const in_double::Outputs o =
            in_double::probe(number, {from[0], from[n], from[2 * n], from[3 * n], from[4 * n], from[5 * n],
                                      from[6 * n], from[7 * n]});
        results[i] = o.x;
        results[n + i] = o.y;
        results[2 * n + i] = o.z;
        results[3 * n + i] = o.w;
    }
    return results;
}

} // namespace lambent::test
