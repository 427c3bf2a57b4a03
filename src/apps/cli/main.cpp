#include "apps/cli/arguments.h"
#include "apps/cli/commands.h"
#include "base/error.h"
#include "base/text.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <variant>

namespace {

using namespace lambent;

void run(const cli::Arguments& arguments)
{
    std::visit(
        [](const auto& command) {
            if constexpr (requires { command.text; })
                std::fputs(command.text.c_str(), stdout);
            else
                cli::run(command);
        },
        arguments);
}

int fail(Failure failure, const char* line)
{
    std::fprintf(stderr, "lambent: error: %s\n", one_line(line).c_str());
    return static_cast<int>(failure);
}

} // namespace

int main(int count, char** words)
{
    // A file over the user's limit is a failed write, as on a full disk: reported, and nothing of it left.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        run(cli::parse_arguments(count, words));
        // A full disk or a closed pipe shows only here.
        return std::fflush(stdout) == 0 ? 0 : fail(Failure::cannot_write, "standard output: cannot write");
    } catch (const Error& error) {
        return fail(error.failure(), error.what());
    } catch (const std::bad_alloc&) {
        return fail(Failure::no_device, "not enough memory");
    } catch (const std::exception& error) {
        return fail(Failure::bad_input, error.what());
    }
}
