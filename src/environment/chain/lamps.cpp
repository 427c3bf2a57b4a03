#include "environment/chain/lamps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lambent::environment {
namespace {

// Each lamp costs time in every lookup; more lamps reduce the error too little for that.
constexpr std::size_t most_lamps = 16;

// Largest distance of a lamp's light from its centre, in texels of the first level that leaves the lamp out.
constexpr double lamp_reach = 1.7;

// Largest texel, in radians, assumed where level 0 is the last with the lamps' light: lobes of any width are read from
// level 0, so lamps must be narrow however small the panorama is.
constexpr double widest_texel = 0.025;

double light_of(const Peak& peak)
{
    return static_cast<double>(peak.light[0]) + static_cast<double>(peak.light[1]) +
           static_cast<double>(peak.light[2]);
}

// Sums over the peaks that become one lamp.
struct LampSum {
    double light[3] = {}, moment[3] = {}, weight = 0.0;

    void add(const Peak& peak)
    {
        const double more = light_of(peak);
        weight += more;
        for (int k = 0; k < 3; ++k) {
            light[k] += static_cast<double>(peak.light[k]);
            moment[k] += more * static_cast<double>(peak.direction[k]);
        }
    }

    double length() const { return std::hypot(moment[0], moment[1], moment[2]); }

    double squared_chord(const Peak& peak) const
    {
        double sum = 0.0;
        for (int k = 0; k < 3; ++k)
            sum += std::pow(moment[k] / length() - static_cast<double>(peak.direction[k]), 2);
        return sum;
    }

    Lamp lamp() const
    {
        Lamp result{};
        for (int k = 0; k < 3; ++k) {
            result.light[k] = static_cast<float>(light[k]);
            result.direction[k] = static_cast<float>(moment[k] / length());
        }
        // The mean of unit vectors is shorter than 1 by their variance.
        result.variance = static_cast<float>(std::max(0.5 * (1.0 - std::pow(length() / weight, 2)), 0.0));
        return result;
    }
};

// Takes the peaks from the brightest on: each joins the nearest lamp within `radius` or starts a new one. Stops when
// there are more than most_lamps.
std::vector<Lamp> gather_lamps(std::vector<Peak> peaks, double radius)
{
    std::sort(peaks.begin(), peaks.end(),
              [](const Peak& a, const Peak& b) { return light_of(a) > light_of(b); });
    std::vector<LampSum> all;
    for (const Peak& peak : peaks) {
        const auto nearest =
            std::min_element(all.begin(), all.end(), [&](const LampSum& a, const LampSum& b) {
                return a.squared_chord(peak) < b.squared_chord(peak);
            });
        if (nearest != all.end() && nearest->squared_chord(peak) < radius * radius)
            nearest->add(peak);
        else
            all.emplace_back().add(peak);
        if (all.size() > most_lamps)
            break;
    }
    std::vector<Lamp> lamps;
    lamps.reserve(all.size());
    for (const LampSum& one : all)
        lamps.push_back(one.lamp());
    return lamps;
}

} // namespace

Lamps choose_lamps(const Peaks& peaks, const CubeChain& chain)
{
    for (int level = 0; level + 1 < chain.levels; ++level) {
        const double next = std::numbers::pi / 2.0 / chain.face_size(level + 1);
        const double texel = level == 0 ? std::min(next, widest_texel) : next;
        std::vector<Lamp> lamps =
            gather_lamps(merged(peaks.peaks, static_cast<float>(0.5 * texel)), lamp_reach * texel);
        if (lamps.size() <= most_lamps)
            return {std::move(lamps), level};
    }
    return {{}, chain.levels};
}

float level_variance(const CubeChain& chain, int level)
{
    const float deviation =
        level == 0 ? 0.25f * level_one_deviation(chain) : std::ldexp(level_one_deviation(chain), level - 1);
    return deviation * deviation;
}

} // namespace lambent::environment
