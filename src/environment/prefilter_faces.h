// Whole faces of cubes, each texel the mean over a lobe about it.
#pragma once

#include "environment/prefilter.h"
#include "image/cube_map.h"

#include <functional>
#include <vector>

namespace lambent::environment {

/// A level of a cube, and what fills it. Faces may have a border of texels whose directions lie beyond their edges: it is
/// a part of their size.
struct PrefilteredFaces {
    image::CubeMap& cube;
    int level;
    Prefilter prefilter;
    int border = 0;
};

/// Fills all of them, on all processors. `report` is called with the share done, by one thread at a time.
void prefilter_faces(const std::vector<PrefilteredFaces>& faces,
                     const std::function<void(double)>& report = {});

} // namespace lambent::environment
