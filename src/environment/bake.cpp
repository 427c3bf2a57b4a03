#include "environment/bake.h"

namespace lambent::environment {

BakedSpecular bake_specular(const Panorama&, const BakeOptions& options, const std::function<void(double)>&)
{
    const int levels = image::full_levels(options.size);
    return {image::make_cube_map(options.size, levels),
            std::vector<BakedLevel>(static_cast<std::size_t>(levels))};
}

image::CubeMap bake_irradiance(const Panorama&, int size)
{
    return image::make_cube_map(size, 1);
}

std::vector<double> irradiance_coefficients(const HarmonicLight&)
{
    return std::vector<double>(27, 0.0);
}

image::RadianceImage bake_split_sum_table(int size)
{
    return {size, size, 3,
            std::vector<float>(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 3)};
}

} // namespace lambent::environment
