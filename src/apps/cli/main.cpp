#include "apps/cli/commands.h"
#include "apps/common/program.h"
#include "apps/options/arguments.h"
#include "apps/report/report_command.h"
#include "apps/serve/serve_command.h"

#include <cstdio>
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

} // namespace

int main(int count, char** words)
{
    return cli::run_program([&] { run(cli::parse_arguments(count, words)); });
}
