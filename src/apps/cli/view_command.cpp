#include "apps/cli/commands.h"
#include "base/error.h"
#include "base/text.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace lambent::cli {

// The window is a program of its own, so that other commands need not load the libraries of windows.
void run(const ViewArguments& arguments)
{
    std::error_code problem;
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", problem);
    const std::filesystem::path window = own.parent_path() / "lambent-view";
    if (problem || ::access(window.c_str(), X_OK) != 0)
        throw Error(Failure::no_device,
                    text("view: ", window.string(),
                         " does not exist: built without GLFW or Dear ImGui; lambent serve "
                         "shows the same in a browser"));
    std::vector<std::string> words = arguments.words;
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::execv(window.c_str(), pointers.data());
    throw Error(Failure::no_device, text("view: ", window.string(), ": ", std::strerror(errno)));
}

} // namespace lambent::cli
