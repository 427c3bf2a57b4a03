// The resolution of pictures of a moving view.
#pragma once

namespace lambent::viewer {

/// Keeps the frame rate by choosing the resolution: a scale of the picture's width and height, in sixteenths. The time
/// for a picture is taken to be proportional to its pixels, and smoothed over several pictures.
class Pace {
public:
    static constexpr double least = 0.25;
    static constexpr double target_ms = 1000.0 / 30.0;

    /// From `least` to 1.
    double scale() const { return scale_; }

    /// Whether even the smallest picture takes longer than this, as far as is known.
    bool is_slower_than(double milliseconds) const { return full_ms_ * least * least > milliseconds; }

    /// Reports that a picture at `scale` took so long in all; values not above 0 are ignored.
    void made(double scale, double milliseconds);

private:
    double scale_ = 0.5;
    double full_ms_ = 0.0; ///< time for a picture at scale 1; 0: unknown
};

} // namespace lambent::viewer
