#include "apps/cli/commands.h"
#include "apps/cli/console.h"
#include "apps/cli/threads.h"
#include "apps/serve/server.h"
#include "base/error.h"
#include "base/text.h"
#include "environment/builtin.h"
#include "scene/builtin.h"

#include <cstdio>
#include <filesystem>

namespace lambent::cli {
namespace {

// The folders of the files that were named: what viewers may open.
std::vector<std::filesystem::path> folders(const ServeArguments& arguments)
{
    std::vector<std::filesystem::path> folders;
    if (!scene::is_builtin(arguments.scene))
        folders.push_back(std::filesystem::path(arguments.scene).parent_path());
    if (arguments.environment != "none" && !environment::is_builtin(arguments.environment))
        folders.push_back(std::filesystem::path(arguments.environment).parent_path());
    return folders;
}

} // namespace

void run(const ServeArguments& arguments)
{
    if (!serve::is_loopback(arguments.host) && arguments.token.empty())
        throw Error(Failure::usage,
                    text("--host ", arguments.host, ": others could come in: --token is needed"));
    const ThreadLimit limit(arguments.common.threads);
    const Console console(arguments.common.verbosity);
    viewer::Wish start{arguments.scene, arguments.environment, {}, viewer::first_eye(arguments.scene), {}};
    viewer::Stock stock(arguments.cache);
    const RenderArguments first = viewer::arguments_of(start);
    stock.load(first);
    console.warn(stock.model(first).value->warnings());
    console.warn(stock.environment(arguments.environment).value->warnings);
    viewer::Desk desk(stock);
    serve::ServerOptions options{arguments.host, arguments.port, arguments.token, {}};
    options.limits.sessions = arguments.sessions;
    serve::Server server(options, start, serve::FileList(folders(arguments)), stock, desk);
    server.stop_on_signals();
    std::printf("%s\n", server.url().c_str());
    if (std::fflush(stdout) != 0)
        throw Error(Failure::cannot_write, "standard output: cannot write");
    server.run();
}

} // namespace lambent::cli
