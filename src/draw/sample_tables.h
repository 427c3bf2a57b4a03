// The points at which specular lobes are sampled, for any backend.
#pragma once

#include <vector>

namespace lambent::draw {

/// One entry per sample, as the hooks of src/shading/README.md want them.
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
    std::vector<Cap> cap;     ///< a sunflower spiral: xi2 = (i + 0.4) / (N + 1), xi1 by the golden ratio
    std::vector<Lobe> lobe;   ///< such a spiral, xi2 = (i + 0.5) / N, or the report's Hammersley pairs
    std::vector<Pixel> pixel; ///< by the powers of the plastic number, independent of `cap`, about (0, 0)
};

/// What `lobe` holds. Hammersley's pairs are (i / N, radical inverse of i in base 2): around a lobe they leave gaps
/// and crowds that show under a sun.
enum class LobePoints { spiral, hammersley };

/// `count` >= 1 samples.
SampleTables make_sample_tables(int count, LobePoints points = LobePoints::spiral);

/// The digits of i in base 2, mirrored about the point: 1 is 0.1, 2 is 0.01, 3 is 0.11. In [0, 1).
double radical_inverse(unsigned i);

} // namespace lambent::draw
