// How good a way to a viewer is, by how long it takes until frames are seen.
#pragma once

#include <algorithm>

namespace lambent::serve {

/// Chooses how well pictures that move are kept: on a slow way they get smaller before they get fewer.
class Link {
public:
    static constexpr int worst = 30, best = 85;

    /// Of the next JPEG.
    int quality() const { return quality_; }

    /// A frame was seen so long after it was sent.
    void seen(double milliseconds)
    {
        constexpr double late = 120.0, early = 60.0;
        if (milliseconds > late)
            quality_ = std::max(worst, quality_ - 10);
        else if (milliseconds < early)
            quality_ = std::min(best, quality_ + 3);
    }

private:
    int quality_ = 75;
};

} // namespace lambent::serve
