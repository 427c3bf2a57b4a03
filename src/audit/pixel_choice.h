// Which pixels are audited.
#pragma once

#include "image/image.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lambent::audit {

struct Place {
    int x = 0, y = 0;
};

/// The pixels with alpha above 0, rows from the top. An image without alpha has none.
std::vector<Place> covered_pixels(const image::RadianceImage& picture);

/// How probable it should be that a pixel is looked at: 1 on average, half of it the same for all, half in proportion to
/// the pixel's contrast, the root mean square difference of its values, cut to [0, cut], to those of its neighbours.
/// Edges and small highlights are where pictures are most wrong.
std::vector<double> interest(const image::RadianceImage& picture, const std::vector<Place>& places,
                             double cut);

struct Candidate {
    Place at;
    double stands_for = 1.0; ///< pixels that it stands for, 1 on average
};

/// Draws `count` of the places, at most all, without replacement, with probabilities in proportion to their sizes (all
/// above 0; none above certainty), evenly along the list, and shuffles them. [systematic sampling with unequal
/// probabilities: Madow 1949]
std::vector<Candidate> drawn(const std::vector<Place>& places, const std::vector<double>& sizes,
                             std::size_t count, std::uint32_t seed);

/// One of several, with the weight that makes the mean over many groups that over all members.
struct Chosen {
    std::size_t index = 0;
    double weight = 1.0; ///< mean score of the group / score of the chosen
};

/// Chooses a member with a probability proportional to its score, all above 0; `random`: 0 to 1, exclusive.
Chosen chosen(std::span<const double> scores, double random);

} // namespace lambent::audit
