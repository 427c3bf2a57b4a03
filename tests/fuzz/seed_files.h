// Inputs for a fuzz target to start from, as files.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace lambent::fuzz {

/// Writes each seed (a range of byte containers) to `folder`/0, 1, ... and their names, comma separated, to
/// `folder`/list. Returns the program's exit code.
template <class Seeds>
int write_seeds(const std::filesystem::path& folder, const Seeds& seeds)
{
    std::ofstream list(folder / "list");
    int number = 0;
    for (const auto& seed : seeds) {
        const std::filesystem::path path = folder / std::to_string(number);
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(seed.data()), static_cast<std::streamsize>(seed.size()));
        list << (number++ > 0 ? "," : "") << path.string();
    }
    return list.good() ? 0 : 1;
}

} // namespace lambent::fuzz
