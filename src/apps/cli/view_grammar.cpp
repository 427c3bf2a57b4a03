#include "apps/cli/view_grammar.h"

namespace lambent::cli {

void ViewGrammar::add(CLI::App& app)
{
    command_ = app.add_subcommand("view", "Show a scene in a window, to be turned and lit");
    command_->add_option("scene", arguments_.scene, "A .gltf or .glb, or a built-in scene")
        ->type_name("SCENE")
        ->required();
    option(*command_, "--env", arguments_.environment, "ENV",
           "A panorama (.hdr, .exr), or kitchen, studio, sky, furnace, none (kitchen)");
    command_->add_flag("--no-cache", no_cache_, "Neither read nor write the environment cache");
    add_common(*command_, common_);
}

ViewArguments ViewGrammar::result() const
{
    ViewArguments arguments = arguments_;
    arguments.common = common_options(common_);
    if (arguments.common.stats_json)
        throw Error(Failure::usage, "--stats: a window's work ends when it is closed");
    arguments.cache = !no_cache_;
    return arguments;
}

} // namespace lambent::cli
