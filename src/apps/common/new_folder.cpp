#include "apps/common/new_folder.h"

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

namespace lambent::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what, const std::string& reason)
{
    throw Error(Failure::cannot_write, text(path.string(), ": ", what, ": ", reason));
}

fs::path without_slash(const fs::path& folder)
{
    const fs::path path = fs::absolute(folder).lexically_normal();
    return path.has_filename() ? path : path.parent_path();
}

bool is_there(const fs::path& path)
{
    std::error_code error;
    return fs::exists(fs::symlink_status(path, error));
}

// The folder and those of its parents that do not exist, the outermost first.
std::vector<fs::path> missing(const fs::path& folder)
{
    std::vector<fs::path> paths;
    for (fs::path path = without_slash(folder); !is_there(path) && path.has_relative_path();
         path = path.parent_path())
        paths.insert(paths.begin(), path);
    return paths;
}

} // namespace

void check_can_make_folder(const fs::path& folder)
{
    const std::vector<fs::path> paths = missing(folder);
    const fs::path around = paths.empty() ? folder : paths.front().parent_path();
    std::error_code error;
    if (!fs::is_directory(around, error))
        fail(around, "cannot write into it", error ? error.message() : "not a folder");
    // A folder can be made where a file can be written.
    check_can_write(paths.empty() ? folder / "bake.json" : paths.front());
}

NewFolder::NewFolder(const fs::path& folder) : folder_(folder)
{
    for (const fs::path& path : missing(folder)) {
        std::error_code error;
        if (!fs::create_directory(path, error) && error) {
            discard();
            fail(folder, "cannot make the folder", error.message());
        }
        made_.push_back(path);
    }
    std::string name = (folder_ / ".lambent-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
        const int reason = errno;
        discard();
        fail(folder, "cannot write into it", std::strerror(reason));
    }
    hidden_ = name;
}

NewFolder::~NewFolder()
{
    discard();
}

void NewFolder::discard()
{
    std::error_code ignored;
    if (!hidden_.empty())
        fs::remove_all(hidden_, ignored);
    for (; !made_.empty(); made_.pop_back())
        fs::remove(made_.back(), ignored); // only if it is empty
}

std::string NewFolder::without_hiding(std::string message) const
{
    const std::string hidden = hidden_.string();
    if (const std::size_t at = message.find(hidden); at != std::string::npos)
        message.replace(at, hidden.size(), folder_.string());
    return message;
}

void NewFolder::put_in_place(const std::vector<std::string>& names, const InputFiles& inputs)
{
    for (const std::string& name : names) {
        check_can_write(folder_ / name);
        inputs.keep_from(folder_ / name);
    }
    for (const std::string& name : names) {
        std::error_code error;
        fs::rename(hidden_ / name, folder_ / name, error);
        if (error)
            fail(folder_ / name, "cannot write", error.message());
    }
}

} // namespace lambent::cli
