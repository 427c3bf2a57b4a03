// The filters of FLIP, one-dimensional: every one of them is a product, or the sum of two products, of a filter along
// rows and one along columns.
//
// Andersson et al. 2020, "FLIP", sections 4.1.2 (contrast sensitivity) and 4.2.1 (feature detection); contrast
// sensitivity after Johnson and Fairchild 2003 and Movshon and Kiorpes 1988, as given there.
#pragma once

#include <vector>

namespace lambent::compare {

/// What the two weights at the same distance have in common.
enum class Shape {
    even,     ///< they are equal
    odd,      ///< one is the other's negative
    zero_sum, ///< they are equal, and all weights add up to 0
};

/// Weights for the offsets -radius to radius.
struct Filter {
    Shape shape = Shape::even;
    int radius = 0;
    std::vector<float> weights; ///< 2 * radius + 1
};

struct FlipFilters {
    Filter achromatic, red_green; ///< one Gaussian each; weights add up to 1
    Filter blue_yellow[2];        ///< two Gaussians; the weights of each add up to 1
    float blue_yellow_share[2];   ///< of each in the filter; together 1
    Filter smooth;                ///< the features' Gaussian; weights add up to 1
    Filter edge;                  ///< its first derivative: negative weights add up to -1, positive to 1
    Filter point;                 ///< its second derivative, likewise
    int radius = 0;               ///< the largest of all
};

/// Pixels that an observer has in a degree of the field of view: 67 is a 3840 pixel wide screen of 0.7 m seen from
/// 0.7 m.
inline constexpr double usual_pixels_per_degree = 67.0;

/// Largest and smallest that make sense: beyond, filters have hundreds of pixels, or no width at all.
inline constexpr double least_pixels_per_degree = 1.0, most_pixels_per_degree = 1000.0;

/// `pixels_per_degree` in the range above, else std::invalid_argument.
FlipFilters make_flip_filters(double pixels_per_degree);

} // namespace lambent::compare
