// Programs as a user runs them.
#pragma once

#include <string>
#include <vector>

namespace lambent::testing {

/// By how much longer programs of this build may take than those of an optimised one: every wait of a test is multiplied by it.
constexpr int patience = LAMBENT_PATIENCE;

struct Outcome {
    int code = -1;          ///< exit code; 128 + n if killed by signal n
    std::string output;     ///< standard output
    std::string error;      ///< standard error
    double seconds = 0.0;   ///< wall clock
    double megabytes = 0.0; ///< peak resident memory
};

/// Runs a program, found through PATH unless it has a slash, with these words. Over `limit_seconds`, times patience,
/// it is killed.
Outcome run_program(const std::string& program, const std::vector<std::string>& words,
                    double limit_seconds = 60.0);

/// What programs run by this process take for the user's cache folder: never the real one.
std::string cache_home();

/// A folder of its own for each test, removed at its end.
class Folder {
public:
    Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder();

    std::string path(const std::string& name) const { return folder_ + "/" + name; }
    std::vector<std::string> names() const; ///< of all files in it

private:
    std::string folder_;
};

} // namespace lambent::testing
