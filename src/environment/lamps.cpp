#include "environment/lamps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lambent::environment {
namespace {

// More of them are not worth what they cost.
constexpr std::size_t most_lamps = 16;

// How far from a lamp's middle its light may come, in texels of the first level that is without it.
constexpr float reach = 1.7f;

float light_of(const Peak& peak)
{
    return peak.light[0] + peak.light[1] + peak.light[2];
}

float squared_chord(const Peak& a, const Peak& b)
{
    float sum = 0.0f;
    for (int k = 0; k < 3; ++k)
        sum += (a.direction[k] - b.direction[k]) * (a.direction[k] - b.direction[k]);
    return sum;
}

// Light moves into `lamp`, whose middle is that of all its light.
void join(Peak& lamp, const Peak& more)
{
    const float share = light_of(more) / std::max(light_of(lamp) + light_of(more), 1e-30f);
    float square = 0.0f;
    for (int k = 0; k < 3; ++k) {
        lamp.light[k] += more.light[k];
        lamp.direction[k] += share * (more.direction[k] - lamp.direction[k]);
        square += lamp.direction[k] * lamp.direction[k];
    }
    for (float& x : lamp.direction)
        x /= std::sqrt(square);
}

// The brightest first, each joins the nearest lamp within `radius` or is a new one. Gives up above most_lamps.
std::vector<Peak> gathered(std::vector<Peak> peaks, float radius)
{
    std::sort(peaks.begin(), peaks.end(),
              [](const Peak& a, const Peak& b) { return light_of(a) > light_of(b); });
    std::vector<Peak> lamps;
    for (const Peak& peak : peaks) {
        const auto nearest = std::min_element(lamps.begin(), lamps.end(), [&](const Peak& a, const Peak& b) {
            return squared_chord(a, peak) < squared_chord(b, peak);
        });
        if (nearest != lamps.end() && squared_chord(*nearest, peak) < radius * radius)
            join(*nearest, peak);
        else
            lamps.push_back(peak);
        if (lamps.size() > most_lamps)
            break;
    }
    return lamps;
}

} // namespace

Lamps choose_lamps(const Peaks& peaks, const CubeChain& chain)
{
    for (int level = 0; level + 1 < chain.levels; ++level) {
        const float texel = std::numbers::pi_v<float> / 2.0f / static_cast<float>(chain.face_size(level + 1));
        std::vector<Peak> lamps = gathered(merged(peaks.peaks, 0.5f * texel), reach * texel);
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
