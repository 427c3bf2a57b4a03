// The files that viewers may open: models and panoramas in the folders that the command line named.
#pragma once

#include "apps/options/arguments.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lambent::viewer {

/// The folders of the files that a command line names.
std::vector<std::filesystem::path> folders_named(const cli::RenderArguments& picture);

class FileList {
public:
    /// Folders are given as typed; one that is not there has no files.
    explicit FileList(std::vector<std::filesystem::path> folders);

    /// Names that may be opened: built-in ones and the files there now, in order; at most `most_files` of them.
    std::vector<std::string> scenes() const;
    std::vector<std::string> environments() const;

    /// Throws Error(usage) for everything else: files elsewhere, by whatever name or link, and files of other kinds.
    void check_scene(const std::string& name) const;
    void check_environment(const std::string& name) const;

    static constexpr std::size_t most_files = 200;
    static constexpr int deepest = 3;

private:
    std::vector<std::string> files(const std::vector<std::string>& kinds) const;
    void check_file(const std::string& name, const std::vector<std::string>& kinds) const;

    std::vector<std::filesystem::path> folders_;
};

} // namespace lambent::viewer
