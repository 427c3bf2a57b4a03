// FLIP's colour pipeline. [Andersson et al. 2020, section 4.1]
#pragma once

#include "compare/plane.h"
#include "image/image.h"

namespace lambent::compare {

/// A colour in each of FLIP's spaces: linear sRGB, CIE XYZ, YyCxCz (Lab without its cube roots), CIELAB.
struct Triple {
    float a, b, c;
};
Triple opponent_of_linear(const Triple& rgb);
Triple linear_of_opponent(const Triple& opponent);
Triple lab_of_linear(const Triple& rgb);

/// Lab with a and b times L / 100: chroma matters less in the dark. [Hunt 1952]
Triple hunt_adjusted(const Triple& lab);

/// |dL| + sqrt(da^2 + db^2). [Abasi et al. 2020, "Distancing from the ideal: HyAB"]
float hyab(const Triple& a, const Triple& b);

/// YyCxCz of a picture.
struct OpponentPlanes {
    Plane achromatic, red_green, blue_yellow;

    explicit OpponentPlanes(const image::RadianceImage& linear);
};

/// Difference in colour of each pixel, 0 to 1, once both are blurred as the eye blurs them.
Plane color_difference(const OpponentPlanes& picture, const OpponentPlanes& reference,
                       double pixels_per_degree);

} // namespace lambent::compare
