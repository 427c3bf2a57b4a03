#include "apps/options/view_grammar.h"

namespace lambent::cli {

void ViewGrammar::add(Command& app)
{
    command_ = app.add_subcommand("view", "Show a scene in a window, to be turned and lit");
    picture_.add(command_);
}

} // namespace lambent::cli
