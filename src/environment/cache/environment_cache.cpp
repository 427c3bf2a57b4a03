#include "environment/cache/environment_cache.h"

#include "base/file.h"
#include "base/text.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <vector>

namespace lambent::environment {
namespace {

namespace fs = std::filesystem;

constexpr const char* ending = ".environment";

std::string hexadecimal(XXH128_hash_t hash)
{
    char digits[33];
    std::snprintf(digits, sizeof digits, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                  static_cast<unsigned long long>(hash.low64));
    return digits;
}

} // namespace

fs::path EnvironmentCache::path_of(const std::string& key) const
{
    return folder_ / (hexadecimal(XXH3_128bits(key.data(), key.size())) + ending);
}

std::optional<MadeEnvironment> EnvironmentCache::find(const std::string& key) const
{
    const fs::path path = path_of(key);
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored))
        return std::nullopt;
    try {
        std::optional<MadeEnvironment> made = from_bytes(read_file(path, limit_));
        if (made) // marks the file as used now
            fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
        return made;
    } catch (const std::exception&) {
        return std::nullopt; // removed meanwhile, or too large for this machine's memory
    }
}

void EnvironmentCache::keep(const std::string& key, const MadeEnvironment& made) const
{
    try {
        const std::vector<std::uint8_t> bytes = to_bytes(made);
        if (bytes.size() > limit_ / 2)
            return;
        fs::create_directories(folder_);
        evict(bytes.size());
        write_file(path_of(key), bytes);
    } catch (const std::exception&) {
        return; // a full disk or a folder without write permission: nothing is cached
    }
}

// Removes the files unused for longest until `bytes` more fit the limit; also temporary files left by a killed process.
void EnvironmentCache::evict(std::uint64_t bytes) const
{
    struct Kept {
        fs::file_time_type used;
        std::uint64_t size;
        fs::path path;
    };
    std::vector<Kept> files;
    std::uint64_t all = bytes;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
        if (!entry.is_regular_file(ignored) ||
            entry.path().filename().string().find(ending) == std::string::npos)
            continue;
        files.push_back({entry.last_write_time(ignored), entry.file_size(ignored), entry.path()});
        all += files.back().size;
    }
    std::sort(files.begin(), files.end(), [](const Kept& a, const Kept& b) { return a.used < b.used; });
    for (std::size_t i = 0; i < files.size() && all > limit_; ++i) {
        fs::remove(files[i].path, ignored);
        all -= files[i].size;
    }
}

std::optional<fs::path> user_cache_folder()
{
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache && fs::path(cache).is_absolute())
        return fs::path(cache) / "lambent";
    const char* home = std::getenv("HOME");
    if (home && fs::path(home).is_absolute())
        return fs::path(home) / ".cache" / "lambent";
    return std::nullopt;
}

std::string content_key(const fs::path& path)
{
    const std::uint64_t size = lambent::file_size(path); // throws a precise error if the file cannot be read
    std::ifstream file(path, std::ios::binary);
    std::vector<char> part(std::size_t{1} << 20);
    XXH3_state_t state;
    XXH3_128bits_reset(&state);
    while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0)
        XXH3_128bits_update(&state, part.data(), static_cast<std::size_t>(file.gcount()));
    return text(hexadecimal(XXH3_128bits_digest(&state)), " ", size);
}

std::string build_key()
{
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none);
    const auto time = fs::last_write_time(program, none).time_since_epoch().count();
    return text(program.string(), " ", static_cast<std::int64_t>(time), " ", fs::file_size(program, none));
}

} // namespace lambent::environment
