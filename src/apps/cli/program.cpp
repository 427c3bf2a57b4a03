#include "apps/cli/program.h"

#include "base/error.h"
#include "base/text.h"
#include "wide/instruction_sets.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

namespace lambent::cli {
namespace {

int fail(Failure failure, const char* line)
{
    std::fprintf(stderr, "lambent: error: %s\n", one_line(line).c_str());
    return static_cast<int>(failure);
}

} // namespace

int run_program(const std::function<void()>& work)
{
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        wide::limit_instructions_by_environment();
        work();
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

} // namespace lambent::cli
