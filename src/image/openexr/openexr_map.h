// OpenEXR's environment maps as panoramas.
#pragma once

#include "image/image.h"
#include "image/reader.h"

#include <memory>

namespace lambent::image {

/// A reader of a map by its projection(), else the one given. X, Y and Z are those of the map.
/// Pixels of these maps lie on the edges of the picture: the first row of latitudes is the zenith, its last column is its
/// first, faces share their edges. Latitudes and longitudes come out in their size, a cube of faces of n pixels as 4 n x 2 n,
/// each texel the mean of 5x5 bilinear lookups. [OpenEXR, ImfEnvmap.h]
/// The map is held in memory once rows are read. Throws Error(bad_input) for a cube too large for that.
std::unique_ptr<RadianceReader> as_equirectangular(std::unique_ptr<RadianceReader> reader,
                                                   const std::string& name);

} // namespace lambent::image
