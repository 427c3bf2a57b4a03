#include "apps/common/input_files.h"

#include "base/error.h"
#include "base/text.h"

#include <system_error>

namespace lambent::cli {
namespace {

namespace fs = std::filesystem;

// Files that do not exist are identified by their resolved paths.
bool is_same(const fs::path& a, const fs::path& b)
{
    std::error_code error;
    if (fs::equivalent(a, b, error) && !error)
        return true;
    const fs::path whole_a = fs::weakly_canonical(a, error);
    if (error)
        return false;
    const fs::path whole_b = fs::weakly_canonical(b, error);
    return !error && whole_a == whole_b;
}

} // namespace

void InputFiles::keep_from(const fs::path& output) const
{
    std::error_code error;
    if (!fs::exists(output, error))
        return;
    for (const fs::path& file : files_)
        if (fs::exists(file, error) && is_same(file, output))
            throw Error(Failure::usage,
                        text(output.string(), ": is read by this command, which will not write over it"));
}

void check_two_outputs(const fs::path& first, const fs::path& second)
{
    if (is_same(first, second))
        throw Error(Failure::usage, text(second.string(), ": two outputs of this command have this name"));
}

} // namespace lambent::cli
