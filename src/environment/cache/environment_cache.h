// A cache of prepared environments in a folder of the user.
#pragma once

#include "environment/cache/environment_bytes.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace lambent::environment {

/// One file per environment, named by a hash of its key. No member throws: an unreadable file counts as missing, and
/// one that cannot be written is not kept. Processes may share a folder: files appear complete or not at all.
class EnvironmentCache {
public:
    /// Keeps at most `limit` bytes in all; the files unused for longest are removed first.
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

/// A key for the content of a file: its hash and size. Throws Error(bad_input) if it cannot be read.
std::string content_key(const std::filesystem::path& path);

/// A key that differs between builds of this program, since their results may differ.
std::string build_key();

} // namespace lambent::environment
