// How many operations on numbers the passes of src/shading take: the text itself, compiled over numbers that count.
#pragma once

namespace lambent::bench {

struct SpecularFlops {
    double sample = 0.0;   ///< of each sample of a lobe
    double fragment = 0.0; ///< of what all samples of a fragment share
    double lamp = 0.0;     ///< of each lamp that the chain is without
};

/// Additions, multiplications, divisions, roots, powers, minima and comparisons of the ggx pass, one each; what a device's
/// sampler does to filter texels is not counted.
SpecularFlops count_specular_flops();

} // namespace lambent::bench
