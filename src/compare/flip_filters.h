// The filters of FLIP, one-dimensional: every one of them is a product, or the sum of two products, of a filter along
// rows and one along columns.
//
// Andersson et al. 2020, "FLIP", sections 4.1.2 (contrast sensitivity) and 4.2.1 (feature detection); contrast
// sensitivity after Johnson and Fairchild 2003 and Movshon and Kiorpes 1988, as given there.
#pragma once

#include <vector>

namespace lambent::compare {

/// The relation of the two weights at the same distance.
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
    float blue_yellow_share[2];   ///< of each Gaussian in the filter; together 1
    Filter smooth;                ///< the features' Gaussian; weights add up to 1
    Filter edge;                  ///< its first derivative: negative weights add up to -1, positive to 1
    Filter point;                 ///< its second derivative, likewise
    int radius = 0;               ///< the largest of all
};

/// Pixels per degree of an observer's field of view: 67 for a screen of 3840 pixels and 0.7 m width seen from 0.7 m.
inline constexpr double usual_pixels_per_degree = 67.0;

/// The accepted range: beyond it filters have no width, or hundreds of pixels.
inline constexpr double least_pixels_per_degree = 1.0, most_pixels_per_degree = 1000.0;

/// Throws std::invalid_argument for `pixels_per_degree` outside that range.
FlipFilters make_flip_filters(double pixels_per_degree);

} // namespace lambent::compare
