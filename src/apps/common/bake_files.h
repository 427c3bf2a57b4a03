// A baked environment as files.
#pragma once

#include "apps/options/arguments.h"
#include "environment/bake/bake.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lambent::cli {

/// The results of a bake. A folder gets all of them, a single file the specular light and the coefficients.
struct Baked {
    environment::BakedSpecular specular;
    std::vector<double> coefficients; ///< nine, each RGB
    std::optional<image::CubeMap> irradiance;
    std::optional<image::RadianceImage> table;
};

/// Size, roughness and error of each level.
nlohmann::ordered_json describe_levels(const environment::BakedSpecular& specular);

/// The texels that are brighter than their format's maximum and will be cut to it.
struct CutLight {
    std::ptrdiff_t texels = 0; ///< how many
    double most = 0.0;         ///< the format's maximum
};
CutLight cut_light(const Baked& baked, const BakeArguments& arguments);

/// Throws Error(cannot_write) if the output evidently cannot be written, Error(usage) if it is the environment's own
/// file. Creates nothing, so that a bake that fails leaves nothing behind.
void check_bake_output(const BakeArguments& arguments);

/// Writes all files and returns their names. A folder gets its files when all of them are complete, bake.json last.
/// `before_file` is called before each. If it throws, or anything else fails, nothing is left behind. Throws
/// Error(cannot_write), and Error(usage) where a file would replace the environment's.
std::vector<std::string> write_baked(const Baked& baked, const BakeArguments& arguments,
                                     const std::function<void()>& before_file);

} // namespace lambent::cli
