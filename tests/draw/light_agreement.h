// Whether a picture with bounces agrees with the path tracer: mean light of blocks of pixels, with the noise of both.
#pragma once

#include "tests/support/random_scene.h"

#include <cstdint>
#include <vector>

namespace lambent::draw::testing {

/// How much work a comparison is worth.
struct Effort {
    int passes = 16;   ///< of each of two drawn pictures
    int samples = 256; ///< of the path tracer
    std::uint32_t seed = 0;
};

/// The mean of a block of pixels, over the mean of what surfaces cover in the true picture.
struct Block {
    double picture = 0.0, truth = 0.0;
    double deviation = 0.0; ///< standard deviation of the noise of both
    double before =
        0.0; ///< what the picture without bounces is off, against its own truth: edges, and what is
             ///< smaller than a pixel

    double off() const { return picture - truth; }
    /// How far it is off that neither noise nor the picture without bounces explains, if noise is taken as this many
    /// standard deviations; 0 or less: it agrees.
    double excess(double deviations) const;
};

/// The whole picture and its blocks of 6 x 6 pixels.
struct Agreement {
    Block whole;
    std::vector<Block> blocks;
    double mean =
        0.0; ///< radiance of what is covered, in the true picture; 0: black, and nothing else is known
    double covered = 0.0; ///< pixels that surfaces cover
};

/// Draws the scene twice, as it is and upside down, which changes the random numbers of each pixel but not the light: the
/// pictures' difference shows their noise. Light is cut at four times the mean, because one mirrored lamp would outweigh
/// everything else.
Agreement compare_light(const lambent::testing::RandomScene& scene, const Effort& effort);

} // namespace lambent::draw::testing
