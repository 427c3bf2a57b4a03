// The files that a command reads, so that it writes over none of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lambent::cli {

class InputFiles {
public:
    InputFiles() = default;

    /// Names that are no files, such as those of built-in scenes, are ignored.
    explicit InputFiles(std::vector<std::filesystem::path> files) : files_(std::move(files)) {}

    void add(const std::filesystem::path& file) { files_.push_back(file); }

    /// Throws Error(usage) if the output is one of them under any name: a relative path, a symbolic or a hard link.
    void keep_from(const std::filesystem::path& output) const;

private:
    std::vector<std::filesystem::path> files_;
};

/// Throws Error(usage) if both name one file, which need not exist: the second output would replace the first.
void check_two_outputs(const std::filesystem::path& first, const std::filesystem::path& second);

} // namespace lambent::cli
