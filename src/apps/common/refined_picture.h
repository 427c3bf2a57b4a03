// Pictures with bounces that are refined until they are as good as asked.
#pragma once

#include "audit/audit.h"
#include "draw/renderer.h"

#include <functional>
#include <memory>
#include <optional>

namespace lambent::cli {

/// When to stop refining; at least one is set.
struct RefineLimits {
    std::optional<double> error;   ///< relative RMSE, as measured
    std::optional<double> seconds; ///< of drawing, with the measurements that `error` needs
};

struct RefinedPicture {
    draw::Frame frame;
    int passes = 0; ///< rounds of rays: draw::Settings::passes of the same picture
    std::optional<audit::Error>
        error; ///< by measurement 0 if it is good enough, else by another; unset: none was made
};

/// Measures the error of a picture (RGBA before exposure). Measurements with different numbers are independent. May
/// return nothing where nothing is seen; then the picture counts as good enough.
///
/// Each picture on the way has a number of its own, from 1 on. One that is good enough is measured again with number 0.
using Measure = std::function<std::optional<audit::Error>(const image::RadianceImage&, std::uint32_t number)>;

/// Told the share that is done, 0 to 1, and the last measurement, if any.
using RefineProgress = std::function<void(float done, const std::optional<audit::Error>& error)>;

/// Draws a picture with bounces from its start with as many passes as the limits need, at most most_passes. `drawing`
/// starts with `passes` passes. Seconds are kept as well as the time of the next pass can be told from those before.
RefinedPicture refined_picture(std::unique_ptr<draw::Drawing> drawing, int passes, const RefineLimits& limits,
                               const Measure& measure, const RefineProgress& progress);

/// Most passes of a picture, as of --passes.
constexpr int most_passes = 4096;

} // namespace lambent::cli
