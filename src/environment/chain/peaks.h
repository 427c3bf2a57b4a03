// The few brightest spots of a panorama: a sun of a few texels, lamps. Whatever reads a picture at points misses some
// of them or counts them twice, so they are taken out and added where they belong.
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
        peaks; ///< what was cut off, one per texel; towards the poles one per as many as are as wide as high
};

/// What exceeds a limit of at least 16 times the mean that leaves at most 1/128 of the sphere above it, and at most what 3000
/// texels fill at the horizon: by solid angle, so that a lamp is taken or not wherever it stands.
Peaks find_peaks(const Panorama& panorama);

/// Neighbouring peaks merged until each is about `spacing` radians from the next; light and its centroid are kept.
std::vector<Peak> merged(const std::vector<Peak>& peaks, float spacing);

/// Adds peaks to a level as Gaussians on the sphere of standard deviation `deviation` (radians). The light that
/// arrives in the level's texels is exactly the peaks' own.
void add_gaussians(const std::vector<Peak>& peaks, float deviation, int level, CubeChain& chain);

/// Box of the texels of a face that a circle of `radius` radians about a peak may touch; x0 > x1 or y0 > y1: none.
struct TexelBox {
    int x0, x1, y0, y1;
};
TexelBox texels_within(const Peak& peak, double radius, int face, int face_size);

} // namespace lambent::environment
