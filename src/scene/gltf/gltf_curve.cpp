#include "scene/gltf/gltf_curve.h"

#include <algorithm>
#include <cmath>

namespace lambent::scene {
namespace {

using Numbers = std::vector<double>;

// The three parts of a key of a cubic curve; keys of other curves have only the second.
enum Part : std::size_t { in_tangent, itself, out_tangent };

Numbers read(const Curve& curve, std::size_t key, Part part = itself)
{
    const bool cubic = curve.interpolation == Interpolation::cubic;
    const std::size_t first = (cubic ? 3 * key + part : key) * curve.width;
    const auto begin = curve.values.begin() + static_cast<std::ptrdiff_t>(first);
    return {begin, begin + static_cast<std::ptrdiff_t>(curve.width)};
}

double dot(const Numbers& a, const Numbers& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
    return sum;
}

Numbers sum(const Numbers& a, double of_a, const Numbers& b, double of_b)
{
    Numbers numbers(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        numbers[i] = of_a * a[i] + of_b * b[i];
    return numbers;
}

// `numbers` normalised, or `otherwise` where a cubic passes through zero.
Numbers unit(const Numbers& numbers, const Numbers& otherwise)
{
    const double length = std::sqrt(dot(numbers, numbers));
    if (!(length > 1e-30))
        return unit(otherwise, {0.0, 0.0, 0.0, 1.0});
    return sum(numbers, 1.0 / length, numbers, 0.0);
}

// [glTF 2.0, C.4]
Numbers slerp(const Numbers& from, const Numbers& to, double t)
{
    const Numbers identity = {0.0, 0.0, 0.0, 1.0};
    const Numbers a = unit(from, identity), b = unit(to, identity);
    const double cosine = dot(a, b), sign = cosine < 0.0 ? -1.0 : 1.0;
    const double angle = std::acos(std::min(std::abs(cosine), 1.0));
    // Shorter arcs are interpolated linearly, since their sines are too small.
    constexpr double straight = 1e-4;
    if (angle < straight)
        return unit(sum(a, 1.0 - t, b, sign * t), a);
    return unit(sum(a, std::sin(angle * (1.0 - t)), b, sign * std::sin(angle * t)), a);
}

// Hermite's cubic, with tangents per second. [glTF 2.0, C.5]
Numbers cubic(const Curve& curve, std::size_t key, double t, double span)
{
    const double t2 = t * t, t3 = t2 * t;
    const Numbers places =
        sum(read(curve, key), 2.0 * t3 - 3.0 * t2 + 1.0, read(curve, key + 1), 3.0 * t2 - 2.0 * t3);
    const Numbers tangents = sum(read(curve, key, out_tangent), span * (t3 - 2.0 * t2 + t),
                                 read(curve, key + 1, in_tangent), span * (t3 - t2));
    const Numbers numbers = sum(places, 1.0, tangents, 1.0);
    return curve.rotation ? unit(numbers, read(curve, key)) : numbers;
}

} // namespace

std::vector<double> value_at(const Curve& curve, double seconds)
{
    const auto after = std::upper_bound(curve.times.begin(), curve.times.end(), seconds,
                                        [](double a, float b) { return a < static_cast<double>(b); });
    const auto next = static_cast<std::size_t>(after - curve.times.begin());
    const std::size_t key = next == 0 ? 0 : next - 1;
    const bool held = next == 0 || next == curve.times.size();
    if (held || curve.interpolation == Interpolation::step) {
        const Numbers value = read(curve, key);
        return curve.rotation ? unit(value, value) : value;
    }
    const auto from = static_cast<double>(curve.times[key]);
    const double span = static_cast<double>(curve.times[next]) - from, t = (seconds - from) / span;
    if (curve.interpolation == Interpolation::cubic)
        return cubic(curve, key, t, span);
    return curve.rotation ? slerp(read(curve, key), read(curve, next), t)
                          : sum(read(curve, key), 1.0 - t, read(curve, next), t);
}

} // namespace lambent::scene
