#include "tests/support/process.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lambent::testing {
namespace {

std::string contents(const std::string& path)
{
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

struct Streams {
    std::string out, err, cache;
};

[[noreturn]] void become(std::string program, const std::vector<std::string>& words, const Streams& streams)
{
    const int output = ::open(streams.out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int error = ::open(streams.err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(error, STDERR_FILENO);
    std::vector<char*> arguments = {program.data()};
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::setenv("XDG_CACHE_HOME", streams.cache.c_str(), 1);
    ::execvp(program.c_str(), arguments.data());
    ::_exit(127);
}

} // namespace

Folder::Folder()
{
    std::string pattern = (std::filesystem::temp_directory_path() / "lambent-test-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
}

Folder::~Folder()
{
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

std::vector<std::string> Folder::names() const
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string cache_home()
{
    static const Folder folder;
    return folder.path("cache");
}

Outcome run_program(const std::string& program, const std::vector<std::string>& words, double limit_seconds)
{
    const Folder folder;
    const Streams streams{folder.path("out"), folder.path("err"), cache_home()};
    const auto start = std::chrono::steady_clock::now();
    const auto elapsed = [start] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const pid_t child = ::fork();
    if (child == 0)
        become(program, words, streams);
    int status = 0;
    rusage usage{};
    while (::wait4(child, &status, WNOHANG, &usage) == 0) {
        if (elapsed() > limit_seconds * patience)
            ::kill(child, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    Outcome outcome;
    outcome.seconds = elapsed();
    outcome.megabytes = static_cast<double>(usage.ru_maxrss) / 1024.0;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.output = contents(streams.out);
    outcome.error = contents(streams.err);
    return outcome;
}

} // namespace lambent::testing
