// Layers of a picture as files.
#pragma once

#include "display/display.h"
#include "draw/frame.h"

#include <filesystem>
#include <vector>

namespace lambent::cli {

/// Writes each layer into a folder, which is made if it does not exist: NAME.exr as it is, and NAME.png to look at
/// (light as displayed, normals from -1..1 to 0..1, depth from near white to far black, exponents by their logarithm).
/// Throws Error(cannot_write).
void write_layers(const std::vector<draw::Layer>& layers, const std::filesystem::path& folder,
                  const display::Settings& display);

} // namespace lambent::cli
