// The error of a drawn picture: measured, and as it is told.
#pragma once

#include "apps/options/arguments.h"
#include "audit/audit.h"
#include "image/notes.h"
#include "reference/pixel_tracer.h"
#include "reference/tracer.h"
#include "scene/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace lambent::cli {

/// Measures errors of pictures that were drawn with `arguments` of a scene, against `lambent reference` with as many
/// bounces. Light is cut where a display shows it white.
class PictureAudit {
public:
    /// Loads the panorama again: that which pictures are drawn from is packed. `scene` must outlive it. Throws
    /// Error(bad_input), Error(no_device).
    PictureAudit(const RenderArguments& arguments, const scene::Scene& scene);

    /// The error of a picture (RGBA before exposure); nothing where nothing is seen (audit::measure). Measurements with
    /// different numbers are independent. `before_each`, if set, is called often, by any thread, and may throw to end it.
    std::optional<audit::Error> error_of(const image::RadianceImage& picture, std::uint32_t number,
                                         const std::function<void()>& before_each = {}) const;

private:
    std::optional<image::RadianceImage> panorama_;
    double cut_;
    std::unique_ptr<reference::PixelTracer> tracer_; ///< uses panorama_, and is why this is not copied
};

/// The error of a picture (RGBA before exposure) that was path-traced with these settings, of which limits and seed have no
/// effect: the audit's random numbers are independent of any seed that a user can give. `panorama`: null: black. Throws
/// Error(no_device).
std::optional<audit::Error> measured_error(const reference::Settings& truth, const scene::Scene& scene,
                                           const image::RadianceImage* panorama,
                                           const image::RadianceImage& picture);

/// "error 3.1 % (2.7 to 3.6)"
std::string in_words(const audit::Error& error);

/// Note "lambent.error": relative RMSE and the ends of its interval, "0.03112 0.02713 0.03604".
image::Notes notes_of(const audit::Error& error);

/// {"relative_rmse", "low", "high", "confidence", "pixels"}
nlohmann::ordered_json to_json(const audit::Error& error);

} // namespace lambent::cli
