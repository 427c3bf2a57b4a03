#include "apps/common/input_names.h"

#include "base/closest.h"
#include "base/error.h"
#include "base/text.h"
#include "environment/builtin/builtin.h"
#include "scene/builtin/builtin.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

namespace lambent::cli {
namespace {

// Checks only that a file exists; its reader reports other errors.
void check(const std::string& name, const char* kind, const std::vector<std::string>& builtin)
{
    std::error_code error;
    if (std::find(builtin.begin(), builtin.end(), name) != builtin.end() ||
        std::filesystem::symlink_status(name, error).type() != std::filesystem::file_type::not_found)
        return;
    throw Error(Failure::bad_input,
                text(name, ": no such file or built-in ", kind, did_you_mean(name, builtin)));
}

std::vector<std::string> list(std::span<const std::string_view> names)
{
    return {names.begin(), names.end()};
}

} // namespace

void check_scene_name(const std::string& name)
{
    check(name, "scene", list(scene::builtin_names()));
}

void check_environment_name(const std::string& name)
{
    std::vector<std::string> names = list(environment::builtin_names());
    names.emplace_back("none");
    check(name, "environment", names);
}

} // namespace lambent::cli
