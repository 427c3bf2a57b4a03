#include "tests/equations/probes/parity.h"
#include "tests/equations/uniform.h"

#include <algorithm>
#include <cstdio>

namespace lambent::test {
namespace {

constexpr float below_one = 0x1.fffffep-1f;

// Three in four uniform, the others nearer to 0 or 1.
double draw(Uniform& uniform)
{
    const double kind = uniform(), u = uniform();
    return kind < 0.75 ? u : kind < 0.875 ? u * u * u * u : 1.0 - u * u * u * u;
}

} // namespace

Arguments random_arguments()
{
    Uniform uniform(1);
    Arguments arguments = {4096, {}};
    for (size_t i = 0; i < probe_inputs * arguments.points; i++)
        arguments.numbers.push_back(std::min(static_cast<float>(draw(uniform)), below_one));
    return arguments;
}

Arguments corner_arguments()
{
    constexpr size_t corners = 6561; // 3^8
    Arguments arguments = {6592, {}};
    for (size_t k = 0, divisor = 1; k < probe_inputs; k++, divisor *= 3)
        for (size_t i = 0; i < arguments.points; i++) {
            const size_t digit = i % corners / divisor % 3;
            arguments.numbers.push_back(digit == 0 ? 0.0f : digit == 1 ? 0.5f : below_one);
        }
    return arguments;
}

Worst compare(const Probe& probe, Bound bound, const std::vector<double>& wanted, const float* results,
              size_t points)
{
    Worst worst;
    for (size_t i = 0; i < wanted.size(); i++) {
        const double difference = std::abs(results[i] - wanted[i]);
        const double ratio = std::isfinite(difference) ? difference / (probe.*bound)(wanted[i]) : HUGE_VAL;
        if (ratio > worst.ratio)
            worst = {ratio, difference, wanted[i], i / points, i % points};
    }
    return worst;
}

std::string describe(const Probe& probe, const Worst& worst, const Arguments& arguments)
{
    char line[256];
    std::snprintf(line, sizeof line, "%-20s %8.3f of its bound: %.2e in %.3g (output %zu) at", probe.name,
                  worst.ratio, worst.difference, worst.wanted, worst.output);
    std::string text = line;
    for (size_t k = 0; k < probe_inputs; k++) {
        std::snprintf(line, sizeof line, " %.9g",
                      static_cast<double>(arguments.numbers[k * arguments.points + worst.point]));
        text += line;
    }
    return text;
}

} // namespace lambent::test
