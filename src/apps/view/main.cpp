// The program of the window: `lambent view` starts it with its own arguments.
#include "apps/options/arguments.h"
#include "apps/common/program.h"
#include "apps/view/view_window.h"
#include "base/error.h"

#include <variant>

using namespace lambent;

int main(int count, char** words)
{
    return cli::run_program([&] {
        const cli::Arguments arguments = cli::parse_arguments(count, words);
        const auto* const view = std::get_if<cli::ViewArguments>(&arguments);
        if (!view)
            throw Error(Failure::usage, "this program is started by lambent view: use that");
        view_window::run(*view);
    });
}
