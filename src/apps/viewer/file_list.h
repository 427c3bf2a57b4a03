// The files that a viewer may open: models and panoramas in the folders of the files on the command line.
#pragma once

#include "apps/options/arguments.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lambent::viewer {

/// The folders of the scene and the environment on a command line.
std::vector<std::filesystem::path> folders_named(const cli::RenderArguments& picture);

class FileList {
public:
    /// Folders are given as typed; those that do not exist are skipped.
    explicit FileList(std::vector<std::filesystem::path> folders);

    /// Names that may be opened: built-in ones, then at most `most_files` files that are there now, sorted.
    std::vector<std::string> scenes() const;
    std::vector<std::string> environments() const;

    /// Throws Error(usage) for all other names: files elsewhere, also by way of links, and files of other kinds.
    void check_scene(const std::string& name) const;
    void check_environment(const std::string& name) const;

    static constexpr std::size_t most_files = 200;
    static constexpr int deepest = 3; ///< levels of folders below those given

private:
    std::vector<std::string> files(const std::vector<std::string>& kinds) const;
    void check_file(const std::string& name, const std::vector<std::string>& kinds) const;

    std::vector<std::filesystem::path> folders_;
};

} // namespace lambent::viewer
