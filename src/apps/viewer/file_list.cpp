#include "apps/viewer/file_list.h"

#include "base/error.h"
#include "base/text.h"
#include "environment/builtin/builtin.h"
#include "scene/builtin/builtin.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace lambent::viewer {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> scene_kinds = {".gltf", ".glb"}, environment_kinds = {".hdr", ".exr"};

bool is_of(const fs::path& file, const std::vector<std::string>& kinds)
{
    return std::find(kinds.begin(), kinds.end(), file.extension().string()) != kinds.end();
}

// Returns whether the file, with links resolved, is in the folder or below.
bool is_in(const fs::path& file, const fs::path& folder)
{
    std::error_code error;
    const fs::path real_file = fs::canonical(file, error);
    if (error || !fs::is_regular_file(real_file, error))
        return false;
    const fs::path real_folder = fs::canonical(folder, error);
    if (error)
        return false;
    return std::mismatch(real_folder.begin(), real_folder.end(), real_file.begin(), real_file.end()).first ==
           real_folder.end();
}

} // namespace

std::vector<fs::path> folders_named(const cli::RenderArguments& picture)
{
    std::vector<fs::path> folders;
    if (!scene::is_builtin(picture.scene))
        folders.push_back(fs::path(picture.scene).parent_path());
    if (picture.environment != "none" && !environment::is_builtin(picture.environment))
        folders.push_back(fs::path(picture.environment).parent_path());
    return folders;
}

FileList::FileList(std::vector<fs::path> folders) : folders_(std::move(folders))
{
    for (fs::path& folder : folders_)
        if (folder.empty())
            folder = ".";
    std::sort(folders_.begin(), folders_.end());
    folders_.erase(std::unique(folders_.begin(), folders_.end()), folders_.end());
}

std::vector<std::string> FileList::files(const std::vector<std::string>& kinds) const
{
    std::vector<std::string> found;
    for (const fs::path& folder : folders_) {
        std::error_code error;
        fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error),
            end;
        // Bounds the time for folders with very many files.
        for (int looked_at = 0; !error && entry != end && looked_at < 10000;
             entry.increment(error), ++looked_at) {
            if (entry.depth() >= deepest)
                entry.disable_recursion_pending();
            if (found.size() < most_files && is_of(entry->path(), kinds) && is_in(entry->path(), folder))
                found.push_back(folder == "." ? entry->path().lexically_relative(".").string()
                                              : entry->path().string());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<std::string> FileList::scenes() const
{
    std::vector<std::string> names(scene::builtin_names().begin(), scene::builtin_names().end());
    const std::vector<std::string> more = files(scene_kinds);
    names.insert(names.end(), more.begin(), more.end());
    return names;
}

std::vector<std::string> FileList::environments() const
{
    std::vector<std::string> names(environment::builtin_names().begin(), environment::builtin_names().end());
    names.emplace_back("none");
    const std::vector<std::string> more = files(environment_kinds);
    names.insert(names.end(), more.begin(), more.end());
    return names;
}

void FileList::check_file(const std::string& name, const std::vector<std::string>& kinds) const
{
    // The system would cut a name at a zero byte.
    const bool clean = !name.empty() && name.find('\0') == std::string::npos && name.size() < 4096;
    const bool allowed = clean && is_of(name, kinds) &&
                         std::any_of(folders_.begin(), folders_.end(),
                                     [&](const fs::path& folder) { return is_in(name, folder); });
    if (!allowed)
        throw Error(Failure::usage,
                    text("'", one_line(name.substr(0, 100)), "' is not among the files that may be opened"));
}

void FileList::check_scene(const std::string& name) const
{
    if (!scene::is_builtin(name))
        check_file(name, scene_kinds);
}

void FileList::check_environment(const std::string& name) const
{
    if (name != "none" && !environment::is_builtin(name))
        check_file(name, environment_kinds);
}

} // namespace lambent::viewer
