#include "apps/viewer/pace.h"

#include <algorithm>
#include <cmath>

namespace lambent::viewer {

void Pace::made(double scale, double milliseconds)
{
    // `spare` leaves a tenth of the time for other work.
    constexpr double spare = 0.9, steps = 16.0, up_margin = 0.92;
    if (!(milliseconds > 0.0) || !(scale > 0.0))
        return;
    const double full_ms = milliseconds / (scale * scale);
    // Slower pictures count more than faster ones, as a late picture is more noticeable than a small one.
    const double share = full_ms > full_ms_ ? 0.5 : 0.2;
    full_ms_ = full_ms_ > 0.0 ? full_ms_ + share * (full_ms - full_ms_) : full_ms;
    const double wanted = std::sqrt(spare * target_ms / full_ms_);
    // The scale grows only by a clear margin, so that it does not alternate between two values.
    const double chosen = std::floor(wanted * steps) / steps;
    if (chosen < scale_ || std::floor(wanted * up_margin * steps) / steps > scale_)
        scale_ = std::clamp(chosen, least, 1.0);
    if (wanted >= 1.0)
        scale_ = 1.0;
}

} // namespace lambent::viewer
