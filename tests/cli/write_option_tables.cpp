// Writes the tables of options in docs/CLI.md anew: write_option_tables PAGE.
#include "tests/cli/option_manual.h"

#include <fstream>
#include <sstream>

int main(int argc, char** argv)
{
    if (argc != 2)
        return 2;
    std::ostringstream page;
    page << std::ifstream(argv[1]).rdbuf();
    std::ofstream(argv[1]) << lambent::cli::with_option_tables(page.str());
    return 0;
}
