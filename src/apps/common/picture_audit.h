// The error of a drawn picture: measured, and as it is told.
#pragma once

#include "apps/options/arguments.h"
#include "audit/audit.h"
#include "image/notes.h"
#include "scene/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace lambent::cli {

/// The error of the picture (RGBA before exposure) that was drawn with `arguments`, against `lambent reference` with as
/// many bounces. Light is cut where a display shows it white. Loads the panorama again: that which pictures are drawn
/// from is packed. Returns nothing where nothing is seen (audit::measure). Throws Error(bad_input), Error(no_device).
std::optional<audit::Error> measured_error(const RenderArguments& arguments, const scene::Scene& scene,
                                           const image::RadianceImage& picture);

/// "error 3.1 % (2.7 to 3.6)"
std::string in_words(const audit::Error& error);

/// Note "lambent.error": relative RMSE and the ends of its interval, "0.03112 0.02713 0.03604".
image::Notes notes_of(const audit::Error& error);

/// {"relative_rmse", "low", "high", "confidence", "pixels"}
nlohmann::ordered_json to_json(const audit::Error& error);

} // namespace lambent::cli
