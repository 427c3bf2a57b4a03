// The few brightest spots of a panorama: a sun of a few texels, lamps. Point sampling would miss some of them or count
// them twice, so they are removed and added exactly.
#pragma once

#include "environment/chain/cube_chain.h"
#include "environment/panorama/panorama.h"

#include <vector>

namespace lambent::environment {

/// Light from one direction: `light` is radiance times solid angle (that is, irradiance facing it), RGB.
struct Peak {
    float direction[3];
    float light[3];
};

struct Peaks {
    float brightest = 0.0f; ///< largest channel of all texels
    float limit = 0.0f;     ///< radiance (largest channel) above which texels were cut
    std::vector<Peak>
        peaks; ///< light above the limit, one per texel, near the poles one per group as wide as high
};

/// Finds the light above a limit. The limit is at least 16 times the mean, and above it are at most 1/128 of the sphere
/// and at most the solid angle of 3000 texels at the horizon, so that a lamp's elevation does not matter.
Peaks find_peaks(const Panorama& panorama);

/// Neighbouring peaks merged until each is about `spacing` radians from the next; light and its centroid are kept.
std::vector<Peak> merged(const std::vector<Peak>& peaks, float spacing);

/// Adds peaks to a level as Gaussians on the sphere of standard deviation `deviation` (radians). The level's texels
/// gain exactly the peaks' light.
void add_gaussians(const std::vector<Peak>& peaks, float deviation, int level, CubeChain& chain);

/// Box of the texels of a face that a circle of `radius` radians about a peak may touch; empty if x0 > x1 or y0 > y1.
struct TexelBox {
    int x0, x1, y0, y1;
};
TexelBox texels_within(const Peak& peak, double radius, int face, int face_size);

} // namespace lambent::environment
