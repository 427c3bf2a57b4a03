// Sample points for specular lobes, the same for all backends.
#pragma once

#include <vector>

namespace lambent::draw {

/// One entry per sample, in the form that the hooks of src/shading/README.md return.
struct SampleTables {
    struct Cap {
        float xi2, cosine, sine;
    };
    struct Lobe {
        float log2_xi2, cosine, sine;
    };
    struct Pixel {
        float x, y;
    };
    std::vector<Cap> cap;     ///< golden-ratio spiral: xi1 = i / phi modulo 1, xi2 = (i + 0.4) / (N + 1)
    std::vector<Lobe> lobe;   ///< the same with xi2 = (i + 0.5) / N, or the report's Hammersley points
    std::vector<Pixel> pixel; ///< from powers of the plastic number, independent of `cap`; mean (0, 0)
};

/// The points in `lobe`. Hammersley points are (i / N, radical inverse of i in base 2); in a lobe they form gaps and
/// clusters, which become visible under a sun.
enum class LobePoints { spiral, hammersley };

/// Makes tables of `count` >= 1 samples.
SampleTables make_sample_tables(int count, LobePoints points = LobePoints::spiral);

/// The binary digits of i, mirrored about the binary point: 1 is 0.1, 2 is 0.01, 3 is 0.11. In [0, 1).
double radical_inverse(unsigned i);

} // namespace lambent::draw
