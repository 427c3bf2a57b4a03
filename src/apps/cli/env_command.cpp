#include "apps/cli/commands.h"
#include "apps/common/stats.h"
#include "apps/common/stopwatch.h"
#include "apps/common/threads.h"
#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "image/files/image_io.h"

#include <nlohmann/json.hpp>

namespace lambent::cli {

void run(const EnvArguments& arguments)
{
    const image::FileKind kind = image::file_kind(arguments.output);
    if (kind != image::FileKind::hdr && kind != image::FileKind::exr)
        throw Error(Failure::usage, text(arguments.output, ": a panorama's name ends in .hdr or .exr"));
    check_can_write(arguments.output);
    const ThreadLimit limit(arguments.common.threads);
    Stopwatch watch;
    const image::RadianceImage panorama = environment::make_builtin(arguments.name, arguments.builtin);
    watch.lap("make");
    image::write_radiance(panorama, arguments.output);
    watch.lap("write");
    if (arguments.common.stats_json) {
        nlohmann::ordered_json stats = {{"command", "env"},
                                        {"environment", arguments.name},
                                        {"output", arguments.output},
                                        {"width", panorama.width},
                                        {"height", panorama.height}};
        add_cost(watch, stats);
        print(stats);
    }
}

} // namespace lambent::cli
