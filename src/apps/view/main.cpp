// The window of `lambent view`, which starts this program and passes its words on.
#include "apps/cli/arguments.h"
#include "apps/view/view_window.h"
#include "base/error.h"
#include "base/text.h"

#include <cstdio>
#include <exception>
#include <new>
#include <variant>

namespace {

using namespace lambent;

int fail(Failure failure, const char* line)
{
    std::fprintf(stderr, "lambent: error: %s\n", one_line(line).c_str());
    return static_cast<int>(failure);
}

} // namespace

int main(int count, char** words)
{
    try {
        const cli::Arguments arguments = cli::parse_arguments(count, words);
        if (const auto* view = std::get_if<cli::ViewArguments>(&arguments))
            view_window::run(*view);
        else
            throw Error(Failure::usage, "this is the window of lambent view: start that");
        return 0;
    } catch (const Error& error) {
        return fail(error.failure(), error.what());
    } catch (const std::bad_alloc&) {
        return fail(Failure::no_device, "not enough memory");
    } catch (const std::exception& error) {
        return fail(Failure::bad_input, error.what());
    }
}
