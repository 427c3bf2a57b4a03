// Prefilters whole faces of cubes: each texel is the mean of light over a lobe about its direction.
#pragma once

#include "environment/bake/prefilter.h"
#include "image/cube/cube_map.h"

#include <functional>
#include <vector>

namespace lambent::environment {

/// A level of a cube, and the prefilter for it. Faces may have a border of texels whose directions lie beyond their
/// edges; the border is part of their size.
struct PrefilteredFaces {
    image::CubeMap& cube;
    int level;
    Prefilter prefilter;
    int border = 0;
};

/// Fills all given faces. `report` is called with the share done, by one thread at a time.
using FillFaces = std::function<void(const std::vector<PrefilteredFaces>& faces,
                                     const std::function<void(double)>& report)>;

/// Fills them on the CPU, in parallel.
void prefilter_faces(const std::vector<PrefilteredFaces>& faces,
                     const std::function<void(double)>& report = {});

/// The texels of a level's faces in tiles of 8x8, with their directions; a tile that is not full repeats its first.
struct FaceTile {
    int face, x, y; ///< of its first texel
    float directions[64][3];
};
std::vector<FaceTile> face_tiles(const PrefilteredFaces& faces);

} // namespace lambent::environment
