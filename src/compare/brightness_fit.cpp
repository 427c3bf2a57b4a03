#include "compare/brightness_fit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lambent::compare {

BrightnessFit brightness_fit(const Pair& pair)
{
    const image::RadianceImage &picture = pair.picture, &reference = pair.reference;
    if (picture.width != reference.width || picture.height != reference.height)
        throw std::invalid_argument("pictures of different size cannot be compared");
    double aa = 0.0, ab = 0.0, bb = 0.0, sum = 0.0, count = 0.0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const float *a = picture.pixel(x, y), *b = reference.pixel(x, y);
            if (picture.channels == 4 && a[3] < 1.0f)
                continue;
            for (int c = 0; c < 3; ++c) {
                const double p = static_cast<double>(a[c]), q = static_cast<double>(b[c]);
                aa += p * p;
                ab += p * q;
                bb += q * q;
                sum += q;
                count += 1.0;
            }
        }
    if (!(sum > 0.0) || !(aa > 0.0))
        return {0.0, 0.0, 0.0};
    const auto relative = [&](double squares) { return std::sqrt(std::max(0.0, squares) * count) / sum; };
    const double factor = ab / aa;
    return {factor, relative(aa - 2.0 * ab + bb), relative(bb - factor * ab)};
}

} // namespace lambent::compare
