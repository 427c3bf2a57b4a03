// Reads and writes whole files. Reading refuses files that are too large; writing never leaves a partial file.
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

/// Size of a regular file in bytes. Throws as read_file.
std::uint64_t file_size(const std::filesystem::path& path);

/// Writes `bytes` under a temporary name beside `path` and renames it when complete: `path` holds its old
/// content or the whole new one, never a part. Throws Error(cannot_write), also when `path` is a folder or a
/// device.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// Throws the Error(cannot_write) of write_file as far as it can be foreseen, so that a mistyped folder is
/// reported before rendering and not after it.
void check_can_write(const std::filesystem::path& path);

} // namespace lambent
