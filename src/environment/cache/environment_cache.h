// Environments that were made before, in a folder of the user's.
#pragma once

#include "environment/cache/environment_bytes.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace lambent::environment {

/// Files named by what they are made from. Nothing here fails aloud: what cannot be read is made again, what cannot be
/// written is not kept. Any number of processes may use one folder; files appear whole, under their name, or not at all.
class EnvironmentCache {
public:
    /// At most `limit` bytes in all: those not used for longest go first.
    EnvironmentCache(std::filesystem::path folder, std::uint64_t limit)
        : folder_(std::move(folder)), limit_(limit)
    {
    }

    std::optional<MadeEnvironment> find(const std::string& key) const;
    void keep(const std::string& key, const MadeEnvironment& made) const;

private:
    std::filesystem::path path_of(const std::string& key) const;
    void evict(std::uint64_t bytes) const;

    std::filesystem::path folder_;
    std::uint64_t limit_;
};

/// $XDG_CACHE_HOME/lambent or ~/.cache/lambent; nothing if the user has neither. [XDG Base Directory Specification 0.8]
std::optional<std::filesystem::path> user_cache_folder();

/// A name for the content of a file. Throws Error(bad_input) where it cannot be read.
std::string content_key(const std::filesystem::path& path);

/// Another name for every build of this program: what one made another may make otherwise.
std::string build_key();

} // namespace lambent::environment
