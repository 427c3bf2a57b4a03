// A folder that gets all of its files or none.
#pragma once

#include "apps/common/input_files.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lambent::cli {

/// Throws Error(cannot_write) if a NewFolder at this path would evidently fail. Creates nothing.
void check_can_make_folder(const std::filesystem::path& folder);

/// Collects files in a hidden folder inside the folder, which may exist already. The destructor removes the hidden
/// folder and those of the folders created that are empty.
class NewFolder {
public:
    /// Creates the folder and its parents where they do not exist. Throws Error(cannot_write).
    explicit NewFolder(const std::filesystem::path& folder);
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;
    ~NewFolder();

    /// The path at which to write a file before put_in_place.
    std::filesystem::path path(const std::string& name) const { return hidden_ / name; }

    /// A message about a file in the hidden folder, with its path in the folder instead.
    std::string without_hiding(std::string message) const;

    /// Moves the files into the folder and replaces older ones of their names. Throws Error(cannot_write), and
    /// Error(usage) where one would replace one of `inputs`: then none is moved.
    void put_in_place(const std::vector<std::string>& names, const InputFiles& inputs);

private:
    void discard();

    std::filesystem::path folder_, hidden_;
    std::vector<std::filesystem::path> made_; ///< folders created, the outermost first
};

} // namespace lambent::cli
