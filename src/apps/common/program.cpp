#include "apps/common/program.h"

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
    return exit_code(failure);
}

} // namespace

int exit_code(Failure failure)
{
    switch (failure) {
    case Failure::over_bound:
        return 1;
    case Failure::usage:
        return 2;
    case Failure::bad_input:
        return 3;
    case Failure::no_device:
        return 4;
    case Failure::cannot_write:
        return 5;
    }
    return 1; // not reached: the switch has all kinds
}

int run_program(const std::function<void()>& work)
{
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        wide::limit_instructions_by_environment();
        work();
        // A full disk or a closed pipe is noticed only here.
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
