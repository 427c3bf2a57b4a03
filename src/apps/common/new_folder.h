// A folder filled as a whole.
#pragma once

#include "apps/common/input_files.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lambent::cli {

/// Throws the Error(cannot_write) that a NewFolder of this name would, as far as can be told. Makes nothing.
void check_can_make_folder(const std::filesystem::path& folder);

/// Files for a folder that may be there already, collected in a hidden folder inside of it. Unless they are all
/// put in place, nothing of them is left, nor of the folders made for them.
class NewFolder {
public:
    /// Makes what is missing. Throws Error(cannot_write).
    explicit NewFolder(const std::filesystem::path& folder);
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;
    ~NewFolder();

    /// Where to write a file until then.
    std::filesystem::path path(const std::string& name) const { return hidden_ / name; }

    /// A message about a file, with the name that it would have had.
    std::string without_hiding(std::string message) const;

    /// Renames the files into place, over older ones of their names. Throws Error(cannot_write), and Error(usage) where
    /// one would replace one of `inputs`: then none is moved.
    void put_in_place(const std::vector<std::string>& names, const InputFiles& inputs);

private:
    void discard();

    std::filesystem::path folder_, hidden_;
    std::vector<std::filesystem::path> made_; ///< the outermost first
};

} // namespace lambent::cli
