#include "apps/options/serve_grammar.h"

namespace lambent::cli {

void ServeGrammar::add(Command& app)
{
    command_ = app.add_subcommand("serve", "Show a scene in browsers, to be turned and lit");
    picture_.add(command_);
    Command server = command_.under("Server");
    option(server, "--port", port_, "P", "The port to listen at; 0: any that is free (8080)");
    option(server, "--host", arguments_.host, "ADDR", "The address to listen at (127.0.0.1)");
    option(server, "--token", arguments_.token, "T",
           "What viewers must know; needed where others than this machine can come in");
    option(server, "--sessions", sessions_, "N", "Viewers at once (8)");
}

ServeArguments ServeGrammar::result() const
{
    ServeArguments arguments = arguments_;
    arguments.start = picture_.start();
    if (!port_.empty())
        arguments.port = static_cast<std::uint16_t>(whole_in(port_, "--port", 0, 65535));
    if (!sessions_.empty())
        arguments.sessions = whole_in(sessions_, "--sessions", 1, 48);
    return arguments;
}

} // namespace lambent::cli
