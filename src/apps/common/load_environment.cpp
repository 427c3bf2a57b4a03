#include "apps/common/load_environment.h"

#include "apps/common/input_names.h"
#include "base/text.h"
#include "environment/builtin/builtin.h"
#include "environment/cache/environment_cache.h"

namespace lambent::cli {
namespace {

constexpr std::uint64_t cache_limit = std::uint64_t{512} << 20;

environment::MadeEnvironment make(const std::string& name)
{
    environment::MadeEnvironment made;
    environment::Panorama panorama = environment::is_builtin(name)
                                         ? environment::make_panorama(environment::make_builtin(name))
                                         : environment::load_panorama(name, made.warnings);
    made.environment = environment::make_environment(std::move(panorama));
    return made;
}

// The name is part of the key because the warnings that are kept contain it.
std::string key_of(const std::string& name)
{
    const std::string content = environment::is_builtin(name) ? "built-in" : environment::content_key(name);
    return text(environment::build_key(), "\n", name, "\n", content);
}

LoadedEnvironment loaded(environment::MadeEnvironment made, bool cached)
{
    return {std::move(made.environment), std::move(made.warnings), cached};
}

} // namespace

LoadedEnvironment load_environment(const std::string& name, bool cache)
{
    if (name == "none")
        return {};
    check_environment_name(name);
    const std::optional<std::filesystem::path> folder = environment::user_cache_folder();
    if (!cache || !folder)
        return loaded(make(name), false);
    const environment::EnvironmentCache kept(*folder, cache_limit);
    const std::string key = key_of(name);
    if (std::optional<environment::MadeEnvironment> found = kept.find(key))
        return loaded(std::move(*found), true);
    environment::MadeEnvironment made = make(name);
    kept.keep(key, made);
    return loaded(std::move(made), false);
}

} // namespace lambent::cli
