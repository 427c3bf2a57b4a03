#include "environment/albedo_quadrature.h"
#include "environment/bake.h"

#include "base/text.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace lambent::environment {

image::RadianceImage bake_split_sum_table(int size)
{
    if (size < 2 || size > 1024)
        throw Error(Failure::usage, text("a split-sum table of ", size, " texels: 2 to 1024 are possible"));
    image::RadianceImage table{size, size, 3, {}};
    table.values.resize(3 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    tbb::parallel_for(0, size, [&](int y) {
        const double roughness = (y + 0.5) / size;
        for (int x = 0; x < size; ++x) {
            const in_double::vec2 pair = directional_albedo(std::max((x + 0.5) / size, least_cosine),
                                                            std::max(roughness * roughness, least_alpha));
            float* texel = table.pixel(x, y);
            texel[0] = static_cast<float>(pair.x);
            texel[1] = static_cast<float>(pair.y);
            texel[2] = static_cast<float>(pair.x + pair.y);
        }
    });
    return table;
}

} // namespace lambent::environment
