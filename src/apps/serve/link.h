// The JPEG quality for a viewer, chosen by how long its frames take to be seen.
#pragma once

#include <algorithm>

namespace lambent::serve {

/// Adapts the JPEG quality of moving views: on a slow connection frames become smaller before they become fewer.
class Link {
public:
    static constexpr int worst = 30, best = 85;

    /// The quality for the next JPEG.
    int quality() const { return quality_; }

    /// Reports how long after sending a frame was seen.
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
