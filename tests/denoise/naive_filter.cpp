#include "tests/denoise/naive_filter.h"

#include <algorithm>
#include <cmath>

namespace lambent::denoise::test {
namespace {

struct Point {
    int x, y;
};

// The picture seen by its pixels.
class Pixels {
public:
    explicit Pixels(const Picture& picture) : p_(picture), g_(picture.guides) {}

    std::size_t index(Point a) const { return static_cast<std::size_t>(a.y * p_.width + a.x); }
    bool covered(Point a) const
    {
        return a.x >= 0 && a.y >= 0 && a.x < p_.width && a.y < p_.height && g_.coverage[index(a)] > 0.0f;
    }
    double depth(Point a) const { return double(g_.depth[index(a)]); }
    double samples(Point a) const { return double(g_.coverage[index(a)]) * double(p_.count[index(a)]); }

    double slope(Point a, Point step) const
    {
        const Point before{a.x - step.x, a.y - step.y}, after{a.x + step.x, a.y + step.y};
        std::vector<double> slopes;
        if (covered(before))
            slopes.push_back(depth(a) - depth(before));
        if (covered(after))
            slopes.push_back(depth(after) - depth(a));
        double least = slopes.empty() ? 0.0 : slopes[0];
        for (double s : slopes)
            least = std::abs(s) <= std::abs(least) ? s : least;
        return std::max(-0.1 * depth(a), std::min(0.1 * depth(a), least));
    }

    double likeness(Point a, Point b, bool lobe) const
    {
        const std::size_t i = index(a), j = index(b);
        double cosine = 0.0;
        for (const Plane& n : g_.normal)
            cosine += double(n[i]) * double(n[j]);
        const double alpha = double(g_.alpha[i]);
        const double power = lobe ? std::clamp(2.0 / (alpha * alpha), 32.0, 1.0e5) : 32.0;
        const double slope = 0.5 * ((slope_of(a, {1, 0}) + slope_of(b, {1, 0})) * (b.x - a.x) +
                                    (slope_of(a, {0, 1}) + slope_of(b, {0, 1})) * (b.y - a.y));
        const double away = std::abs(depth(b) - depth(a) - slope);
        const double tolerance = 0.002 * (depth(a) + depth(b)) + 0.5 * std::abs(slope);
        const double material = std::abs(std::sqrt(alpha) - std::sqrt(double(g_.alpha[j]))) +
                                std::abs(double(g_.metalness[i]) - double(g_.metalness[j]));
        const double halvings = (power * (1.0 - cosine) + away / tolerance + material / 0.03) / std::log(2.0);
        const double whole = std::floor(halvings);
        return halvings < 20.0 ? std::exp2(-whole) * (1.0 - 0.5 * (halvings - whole)) : 0.0;
    }

    // visit(neighbour, weight) for the covered ones of n x n.
    template <class Visit>
    void for_each_near(Point a, int n, int step, bool lobe, Visit&& visit) const
    {
        const std::vector<double> five = {1, 4, 6, 4, 1}, three = {1, 2, 1};
        const std::vector<double>& row = n == 5 ? five : three;
        const double all = n == 5 ? 256.0 : 16.0;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const Point b{a.x + (i - n / 2) * step, a.y + (j - n / 2) * step};
                if (covered(b))
                    visit(b, row[std::size_t(i)] * row[std::size_t(j)] / all *
                                 (b.x == a.x && b.y == a.y ? 1.0 : likeness(a, b, lobe)));
            }
    }

    template <class Visit>
    void for_each(Visit&& visit) const
    {
        for (int y = 0; y < p_.height; ++y)
            for (int x = 0; x < p_.width; ++x)
                if (covered({x, y}))
                    visit(Point{x, y});
    }

private:
    double slope_of(Point a, Point step) const { return slope(a, step); }

    const Picture& p_;
    const Guides& g_;
};

// The share of exact light that is a control variate, at the centre of the square of 16 pixels that `square` counts.
double share_of_square(const Pixels& pixels, const Light& light, Point square)
{
    double unshadowed = 0.0, found = 0.0;
    for (int y = 16 * (square.y - 1); y < 16 * (square.y + 2); ++y)
        for (int x = 16 * (square.x - 1); x < 16 * (square.x + 2); ++x)
            for (std::size_t k = 0; k < 6 && pixels.covered({x, y}); ++k) {
                const std::size_t i = pixels.index({x, y});
                unshadowed += pixels.samples({x, y}) * double(light.halves[k / 3].unshadowed[k % 3][i]);
                found += pixels.samples({x, y}) * double(light.halves[k / 3].found[k % 3][i]);
            }
    return unshadowed > 0.0 ? std::min(1.0, std::pow(2.0 * found / unshadowed, 2.0)) : 1.0;
}

// The mean of the shares of all squares, as near as their centres are.
DoublePlane shares_of(const Pixels& pixels, const Light& light, int width, int height)
{
    const int columns = (width + 15) / 16, rows = (height + 15) / 16;
    std::vector<double> squares;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            squares.push_back(share_of_square(pixels, light, {column, row}));
    DoublePlane shares;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double across = std::clamp((x + 0.5) / 16.0 - 0.5, 0.0, columns - 1.0),
                         down = std::clamp((y + 0.5) / 16.0 - 0.5, 0.0, rows - 1.0);
            double share = 0.0;
            for (int row = 0; row < rows; ++row)
                for (int column = 0; column < columns; ++column)
                    share += std::max(0.0, 1.0 - std::fabs(across - column)) *
                             std::max(0.0, 1.0 - std::fabs(down - row)) *
                             squares[static_cast<std::size_t>(row * columns + column)];
            shares.push_back(share);
        }
    return shares;
}

using Sums = std::array<DoublePlane, 15>; // unshadowed, found of both halves, weight; three channels each

Sums unfiltered(const Pixels& pixels, const Light& light)
{
    Sums sums;
    for (DoublePlane& plane : sums)
        plane.resize(light.exact[0].size());
    const bool textured = !light.albedo[0].empty();
    pixels.for_each([&](Point a) {
        const std::size_t i = pixels.index(a);
        for (std::size_t c = 0; c < 3; ++c) {
            const double albedo = textured ? std::max(double(light.albedo[c][i]), 1e-5) : 1.0;
            const double scale = pixels.samples(a) / (textured ? albedo + 0.01 : 1.0);
            for (std::size_t h = 0; h < 2; ++h) {
                sums[6 * h + c][i] = scale * double(light.halves[h].unshadowed[c][i]);
                sums[6 * h + 3 + c][i] = scale * double(light.halves[h].found[c][i]);
            }
            sums[12 + c][i] = scale * albedo;
        }
    });
    return sums;
}

Sums smoothed(const Pixels& pixels, const Sums& from, int step, bool lobe)
{
    Sums to;
    for (DoublePlane& plane : to)
        plane.resize(from[0].size());
    pixels.for_each([&](Point a) {
        pixels.for_each_near(a, 5, step, lobe, [&](Point b, double weight) {
            for (std::size_t k = 0; k < from.size(); ++k)
                to[k][pixels.index(a)] += weight * from[k][pixels.index(b)];
        });
    });
    return to;
}

// Both candidates of a level.
struct Known {
    const Light& light;
    const DoublePlane& shares;
};
void add_candidates(const Pixels& pixels, const Known& known, const Sums& sums, const Settings& settings,
                    std::array<DoubleRgb, 2>* to)
{
    const Light& light = known.light;
    pixels.for_each([&](Point a) {
        const std::size_t i = pixels.index(a);
        const double share = known.shares[i];
        for (std::size_t h = 0; h < 2; ++h)
            for (std::size_t c = 0; c < 3; ++c) {
                const double exact = double(light.exact[c][i]);
                const double albedo =
                    light.albedo[0].empty() ? 1.0 : std::max(double(light.albedo[c][i]), 1e-5);
                const double unshadowed = sums[6 * h + c][i], found = sums[6 * h + 3 + c][i],
                             weight = sums[12 + c][i];
                const double control = share * exact + albedo * (found - share * unshadowed) / weight;
                const auto limit = double(settings.ratio_limit);
                const double beyond = albedo * std::max(found - limit * unshadowed, 0.0) / weight;
                const bool valid = albedo * unshadowed / weight > 1e-3 * exact;
                to[0][h][c][i] = control;
                to[1][h][c][i] =
                    valid ? exact * std::clamp(found / unshadowed, 0.0, limit) + beyond : control;
            }
    });
}

DoublePlane pooled(const Pixels& pixels, const DoublePlane& from, int step)
{
    DoublePlane to(from.size());
    pixels.for_each([&](Point a) {
        pixels.for_each_near(a, 3, step, false, [&](Point b, double weight) {
            to[pixels.index(a)] += weight * from[pixels.index(b)];
        });
    });
    return to;
}

using Candidate = std::array<DoubleRgb, 2>; // light of both halves

// Errors of a candidate against the other half's target, pooled.
DoublePlane errors_of(const Pixels& pixels, const Light& light, const Candidate& candidate,
                      const Candidate& target, double cut)
{
    DoublePlane error(light.exact[0].size());
    pixels.for_each([&](Point a) {
        const std::size_t i = pixels.index(a);
        for (std::size_t c = 0; c < 3; ++c) {
            const double exact = double(light.exact[c][i]), sight = exact > cut ? cut / exact : 1.0;
            for (std::size_t h = 0; h < 2; ++h)
                error[i] +=
                    pixels.samples(a) * std::pow(sight * (candidate[h][c][i] - target[1 - h][c][i]), 2.0);
        }
    });
    for (int step : {1, 2, 4})
        error = pooled(pixels, error, step);
    return error;
}

std::vector<int> least_of(const std::vector<DoublePlane>& errors)
{
    std::vector<int> least(errors[0].size());
    for (std::size_t i = 0; i < least.size(); ++i)
        for (std::size_t k = 1; k < errors.size(); ++k)
            if (errors[k][i] < errors[static_cast<std::size_t>(least[i])][i])
                least[i] = static_cast<int>(k);
    return least;
}

std::vector<int> choices_of(const Pixels& pixels, const Light& light, const NaiveResult& r,
                            const Settings& settings)
{
    const auto cut = double(settings.cut);
    const std::vector<Candidate> targets = {r.candidates[0], r.candidates[2], r.candidates[3]};
    std::vector<DoublePlane> errors;
    for (const Candidate& candidate : targets)
        errors.push_back(errors_of(pixels, light, candidate, r.candidates[0], cut));
    const std::vector<int> named = least_of(errors);
    Candidate target = targets[0];
    for (std::size_t i = 0; i < named.size(); ++i)
        for (std::size_t h = 0; h < 2; ++h)
            for (std::size_t c = 0; c < 3; ++c)
                target[h][c][i] = targets[static_cast<std::size_t>(named[i])][h][c][i];
    errors.clear();
    for (const Candidate& candidate : r.candidates)
        errors.push_back(errors_of(pixels, light, candidate, target, cut));
    return least_of(errors);
}

} // namespace

NaiveResult naive_filter(const Picture& picture, const Light& light, bool lobe, const Settings& settings)
{
    const Pixels pixels(picture);
    const DoublePlane black(light.exact[0].size());
    NaiveResult r;
    r.light = r.gap = {black, black, black};
    const DoublePlane shares = shares_of(pixels, light, picture.width, picture.height);
    Sums sums = unfiltered(pixels, light);
    for (std::size_t level = 0; level < naive_levels; ++level) {
        if (level > 0)
            sums = smoothed(pixels, sums, 1 << (level - 1), lobe);
        for (std::size_t k = 0; k < 2; ++k)
            r.candidates[2 * level + k] = {r.light, r.light};
        add_candidates(pixels, {light, shares}, sums, settings, &r.candidates[2 * level]);
    }
    r.choices = choices_of(pixels, light, r, settings);
    pixels.for_each([&](Point a) {
        const std::size_t i = pixels.index(a);
        double total = 0.0;
        pixels.for_each_near(a, 3, 1, false, [&](Point, double weight) { total += weight; });
        pixels.for_each_near(a, 3, 1, false, [&](Point b, double weight) {
            const std::array<DoubleRgb, 2>& chosen = r.candidates[std::size_t(r.choices[pixels.index(b)])];
            for (std::size_t c = 0; c < 3; ++c) {
                r.light[c][i] += weight / total * 0.5 * (chosen[0][c][i] + chosen[1][c][i]);
                r.gap[c][i] += weight / total * (chosen[0][c][i] - chosen[1][c][i]);
            }
        });
        for (DoublePlane& plane : r.light)
            plane[i] = std::max(plane[i], 0.0);
    });
    return r;
}

} // namespace lambent::denoise::test
