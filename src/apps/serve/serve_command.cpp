#include "apps/serve/serve_command.h"

#include "apps/common/console.h"
#include "apps/common/threads.h"
#include "apps/serve/server.h"
#include "apps/viewer/load_first.h"
#include "base/error.h"
#include "base/text.h"

#include <cstdio>

namespace lambent::cli {
void run(const ServeArguments& arguments)
{
    if (!serve::is_loopback(arguments.host) && arguments.token.empty())
        throw Error(Failure::usage,
                    text("--host ", arguments.host, ": other machines could connect: --token is required"));
    const RenderArguments& picture = arguments.start.picture;
    const ThreadLimit limit(picture.common.threads);
    const Console console(picture.common.verbosity);
    viewer::AssetCache assets({picture.cache,
                               picture.backend,
                               [&](const std::string& line) { console.warn({line}); },
                               picture.common.strict,
                               {false, viewer::folders_named(picture)}});
    const viewer::ViewRequest start = viewer::load_first(arguments.start, assets, console);
    viewer::DrawScheduler scheduler(assets);
    serve::ServerOptions options{arguments.host, arguments.port, arguments.token, {}};
    options.limits.sessions = arguments.sessions;
    serve::Server server(options, start, viewer::FileList(viewer::folders_named(picture)), assets, scheduler);
    server.stop_on_signals();
    std::printf("%s\n", server.url().c_str());
    if (std::fflush(stdout) != 0)
        throw Error(Failure::cannot_write, "standard output: cannot write");
    server.run();
}

} // namespace lambent::cli
