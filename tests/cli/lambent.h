// The program under test.
#pragma once

#include "tests/support/process.h"

#include <fstream>

namespace lambent {

inline testing::Outcome lambent(const std::vector<std::string>& words)
{
    return testing::run_program(LAMBENT_PROGRAM, words);
}

inline void write_bytes(const std::string& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

} // namespace lambent
