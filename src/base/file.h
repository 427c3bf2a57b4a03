// Whole files in, whole files out: a reader that refuses what is too large, a writer that leaves no part
// behind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace lambent {

/// The bytes of a regular file.
/// Throws Error(bad_input) when it is missing, a folder, unreadable, or larger than `limit` bytes.
std::vector<std::uint8_t> read_file(const std::filesystem::path& path,
                                    std::uint64_t limit = std::uint64_t{1} << 34);

/// The first bytes of a regular file, at most `count`. Throws as read_file.
std::vector<std::uint8_t> read_start(const std::filesystem::path& path, std::size_t count);

/// Size in bytes of a regular file, or Error(bad_input) as read_file.
std::uint64_t file_size(const std::filesystem::path& path);

/// Writes `bytes` under a temporary name beside `path` and renames it when complete: `path` holds its old
/// content or the whole new one, never a part. Throws Error(cannot_write), also when `path` is a folder or a
/// device.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// Throws the Error(cannot_write) that write_file would, as far as can be told before the work: for a
/// mistyped folder to be reported at once and not after the rendering.
void check_can_write(const std::filesystem::path& path);

} // namespace lambent
