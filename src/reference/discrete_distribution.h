// Random choice among numbered entries, with probabilities proportional to weights.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

namespace lambent::reference {

/// A discrete distribution, sampled by its cumulative sums. `Number` is the type in which these are stored: long
/// lists of floats fit a processor's caches where doubles do not. Probabilities are differences of the stored sums,
/// which makes them exactly those of draw(). Entries of weight 0 are never drawn.
template <class Number>
class DiscreteDistribution {
public:
    DiscreteDistribution() = default;

    /// Throws std::invalid_argument if a weight is negative or NaN, or if their sum is not finite.
    explicit DiscreteDistribution(std::span<const double> weights)
    {
        std::vector<double> sums;
        sums.reserve(weights.size());
        for (const double weight : weights) {
            if (!(weight >= 0.0))
                throw std::invalid_argument("a weight of a distribution is negative or not a number");
            sums.push_back(sum_ += weight);
        }
        if (!std::isfinite(sum_))
            throw std::invalid_argument("the weights of a distribution have no finite sum");
        ends_.reserve(sums.size());
        for (const double sum : sums)
            ends_.push_back(static_cast<Number>(sum / (sum_ > 0.0 ? sum_ : 1.0)));
        for (std::size_t first = 0; first < ends_.size(); first += block)
            block_ends_.push_back(ends_[std::min(first + block, ends_.size()) - 1]);
    }

    /// Sum of the weights. Nothing can be drawn if it is 0.
    double sum() const { return sum_; }

    struct Drawn {
        std::size_t index;
        double place; ///< position of u in the interval that gives this entry, 0 to 1; uniform again
    };

    /// Draws an entry. `u` is in [0, 1).
    Drawn draw(double u) const
    {
        // Searching for a block, then for the entry in it, reads only contiguous memory.
        const std::size_t first = block * first_above(block_ends_, u);
        const std::span<const Number> ends(ends_);
        const std::size_t index =
            first + first_above(ends.subspan(first, std::min(block, ends.size() - first)), u);
        return {index, std::clamp((u - start(index)) / std::max(probability(index), 1e-300), 0.0, 1.0)};
    }

    /// Probability of drawing an entry.
    double probability(std::size_t index) const { return end(index) - start(index); }

private:
    static constexpr std::size_t block = 32;

    // Index of the first cumulative sum above u, or of the last one if there is none.
    static std::size_t first_above(std::span<const Number> ends, double u)
    {
        const auto above = [](double a, Number b) { return a < static_cast<double>(b); };
        return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end() - 1, u, above) -
                                        ends.begin());
    }

    double start(std::size_t index) const { return index > 0 ? static_cast<double>(ends_[index - 1]) : 0.0; }
    double end(std::size_t index) const
    {
        return index + 1 < ends_.size() ? static_cast<double>(ends_[index]) : 1.0;
    }

    double sum_ = 0.0;
    std::vector<Number> ends_;       // cumulative sums up to and including each entry; the last is 1
    std::vector<Number> block_ends_; // cumulative sums at the last entry of each block
};

} // namespace lambent::reference
