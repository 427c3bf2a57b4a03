// How large pictures may be while things move.
#pragma once

namespace lambent::viewer {

/// Holds a rate by the resolution: a part of the picture's width and height, in sixteenths. A picture is taken to cost in
/// proportion to its pixels; what it costs is remembered over a few of them.
class Pace {
public:
    static constexpr double least = 0.25;
    static constexpr double target_ms = 1000.0 / 30.0;

    /// From `least` to 1.
    double scale() const { return scale_; }

    /// A picture was made at `scale` and took this long in all, above 0.
    void made(double scale, double milliseconds);

private:
    double scale_ = 0.5;
    double full_ms_ = 0.0; ///< of a picture at scale 1; 0: unknown
};

} // namespace lambent::viewer
