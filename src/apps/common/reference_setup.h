// Inputs of path tracing that drawing does not need.
#pragma once

#include "apps/options/arguments.h"
#include "base/error.h"
#include "image/image.h"
#include "reference/tracer.h"

#include <optional>
#include <string>

namespace lambent::cli {

/// The environment's panorama, not prepared for lookups; nothing for "none". Throws Error(bad_input).
std::optional<image::RadianceImage> load_raw_environment(const std::string& name, Warnings& warnings);

/// The settings of the path tracer for a command line. Throws as choose_camera.
reference::Settings reference_settings(const ReferenceArguments& arguments, const scene::Scene& scene);

} // namespace lambent::cli
