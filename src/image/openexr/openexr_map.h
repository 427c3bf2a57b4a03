// Converts OpenEXR environment maps to panoramas.
#pragma once

#include "image/image.h"
#include "image/reader.h"

#include <memory>

namespace lambent::image {

/// A reader that converts an environment map by its projection() to an equirectangular panorama with the map's axes; or
/// `reader` itself if its projection is unknown.
/// The outermost pixels of these maps lie on the edges of the image: the first row of a latitude-longitude map is the
/// zenith, its last column equals the first, and faces of a cube share their edges. A latitude-longitude map keeps its
/// size, a cube with faces of n pixels becomes 4n x 2n, each texel the mean of 5x5 bilinear lookups. [OpenEXR,
/// ImfEnvmap.h] The whole map is in memory once rows are read. Throws Error(bad_input) if the panorama of a cube
/// exceeds the limits on images (refuse.h).
std::unique_ptr<RadianceReader> as_equirectangular(std::unique_ptr<RadianceReader> reader,
                                                   const std::string& name);

} // namespace lambent::image
