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

/// What a folder gets. One file gets the specular light and the coefficients.
struct Baked {
    environment::BakedSpecular specular;
    std::vector<double> coefficients; ///< 27
    std::optional<image::CubeMap> irradiance;
    std::optional<image::RadianceImage> table;
};

/// Size, roughness and error of each level.
nlohmann::ordered_json describe_levels(const environment::BakedSpecular& specular);

/// Texels that the files will cut to the brightest light that their format holds.
struct CutLight {
    std::ptrdiff_t texels = 0;
    double most = 0.0; ///< what the format holds
};
CutLight cut_light(const Baked& baked, const BakeArguments& arguments);

/// Throws Error(cannot_write) for what is plain before the work, Error(usage) for the environment's own file. Makes nothing yet, so that nothing is left of
/// a bake that fails.
void check_bake_output(const BakeArguments& arguments);

/// Writes everything and returns the files' names. A folder gets its files when all of them are complete;
/// bake.json comes last. `before_file` is called before each; what it throws, as any other failure, leaves
/// nothing behind. Throws Error(cannot_write), and Error(usage) where a file would replace the environment's.
std::vector<std::string> write_baked(const Baked& baked, const BakeArguments& arguments,
                                     const std::function<void()>& before_file);

} // namespace lambent::cli
