// What path tracing needs besides what drawing does.
#pragma once

#include "apps/options/arguments.h"
#include "base/error.h"
#include "image/image.h"
#include "reference/tracer.h"

#include <optional>
#include <string>

namespace lambent::cli {

/// The environment as it is in the file, unprepared; nothing for "none". Throws Error(bad_input).
std::optional<image::RadianceImage> load_raw_environment(const std::string& name, Warnings& warnings);

/// What a command line asks of the path tracer. Throws as choose_camera.
reference::Settings reference_settings(const ReferenceArguments& arguments, const scene::Scene& scene);

} // namespace lambent::cli
