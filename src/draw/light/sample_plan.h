// Where a picture's samples go.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent::draw {

/// Numbers of samples for squares of 8x8 pixels, pass by pass. The first pass gives every pixel as many; later ones
/// give most to squares whose error each sample lowers most, fewer in all. [Neyman allocation, in proportion to the standard
/// deviation of a sample: Neyman 1934, "On the two different aspects of the representative method"]
class SamplePlan {
public:
    static constexpr int side = 8; ///< of a square, pixels
    static constexpr std::uint32_t of_pass =
        2; ///< samples of a pixel in a pass that is not planned, one of each half
    static constexpr std::uint32_t at_most = 16; ///< of a pixel in a pass

    SamplePlan(int width, int height);

    /// What is known of a square before a pass.
    struct Square {
        double error = 0.0;   ///< sum of the squared errors of its pixels
        double covered = 0.0; ///< pixels with surfaces
    };
    std::size_t size() const { return wanted_.size(); } ///< squares
    std::size_t square_of(int x, int y) const
    {
        return static_cast<std::size_t>(y / side * columns_ + x / side);
    }

    /// Plans the next pass. `squares`: of all, by square_of().
    void plan(const std::vector<Square>& squares);

    /// Samples of a pixel in the current pass, an even number, and before it.
    std::uint32_t wanted(int x, int y) const { return wanted_[square_of(x, y)]; }
    std::uint32_t taken(int x, int y) const { return taken_[square_of(x, y)]; }

    /// Ends a pass; the next one has the same numbers unless it is planned.
    void end_pass();

private:
    std::vector<double> deviations(const std::vector<Square>& squares) const;
    std::uint32_t wanted_with(double samples, std::size_t square) const;

    int columns_, rows_;
    std::vector<std::uint32_t> wanted_, taken_; ///< by square
};

} // namespace lambent::draw
