// Layers of a picture as files.
#pragma once

#include "display/display.h"
#include "draw/frame.h"

#include <filesystem>
#include <vector>

namespace lambent::cli {

/// Creates the folder for layers if it does not exist. Called before drawing, so that errors come early. Throws
/// Error(cannot_write).
void make_layer_folder(const std::filesystem::path& folder);

/// A layer as its .png: light as displayed, normals from -1..1 to 0..1, depth from near white to far black, exponents
/// by their logarithm.
image::CodeImage layer_picture(const draw::Layer& layer, const display::Settings& display);

/// Writes each layer into a folder: NAME.exr with its values, NAME.png by layer_picture. Throws Error(cannot_write).
void write_layers(const std::vector<draw::Layer>& layers, const std::filesystem::path& folder,
                  const display::Settings& display);

/// The files that write_layers writes.
std::vector<std::filesystem::path> layer_files(const std::vector<draw::Layer>& layers,
                                               const std::filesystem::path& folder);

} // namespace lambent::cli
