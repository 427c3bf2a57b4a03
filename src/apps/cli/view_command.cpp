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
namespace {

// The words that the window's own program reads its arguments from again.
std::vector<std::string> words_of(const StartArguments& start)
{
    const RenderArguments& picture = start.picture;
    std::vector<std::string> words = {"lambent", "view"};
    const auto add = [&](const std::string& option, const std::string& word) {
        words.insert(words.end(), {option, word});
    };
    const auto add_flag = [&](bool given, const char* flag) {
        if (given)
            words.emplace_back(flag);
    };
    add("--env", picture.environment);
    for (const auto& [name, word] : start.words)
        words.push_back(text("--", name, "=", word)); // a word may look like an option
    for (const std::string& light : start.lights)
        add("--light", light);
    if (!picture.camera_node.empty())
        add("--camera-node", picture.camera_node);
    if (picture.common.threads > 0)
        add("--threads", text(picture.common.threads));
    add_flag(!picture.cache, "--no-cache");
    add_flag(!picture.settings.energy_compensation, "--no-energy-compensation");
    add_flag(picture.display.dither, "--dither");
    add_flag(picture.common.strict, "--strict");
    add_flag(picture.common.verbosity == Verbosity::quiet, "--quiet");
    add_flag(picture.common.verbosity == Verbosity::verbose, "--verbose");
    add("--", picture.scene); // a name may look like an option
    return words;
}

} // namespace

// The window is a program of its own: everything else starts without what windows need.
void run(const ViewArguments& arguments)
{
    std::error_code problem;
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", problem);
    const std::filesystem::path window = own.parent_path() / "lambent-view";
    if (problem || ::access(window.c_str(), X_OK) != 0)
        throw Error(Failure::no_device, text("view: ", window.string(),
                                             " is not there: built without GLFW or Dear ImGui; lambent serve "
                                             "shows the same in a browser"));
    std::vector<std::string> words = words_of(arguments.start);
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::execv(window.c_str(), pointers.data());
    throw Error(Failure::no_device, text("view: ", window.string(), ": ", std::strerror(errno)));
}

} // namespace lambent::cli
