// A baked environment as files.
#pragma once

#include "apps/cli/arguments.h"
#include "environment/bake.h"

#include <filesystem>
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

/// Makes the folder, if it is one. Throws Error(cannot_write) for what is plain before the work.
void check_bake_output(const BakeArguments& arguments);

/// Writes everything, bake.json last; each file whole or not at all. Returns their names. Throws Error(cannot_write).
std::vector<std::string> write_baked(const Baked& baked, const BakeArguments& arguments);

} // namespace lambent::cli
