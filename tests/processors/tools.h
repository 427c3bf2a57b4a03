// Programs of others that tests run ours by.
#pragma once

#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace lambent::processors {

/// Why a test is skipped: the program is not there; else empty. Where LAMBENT_REQUIRE_EMULATORS is set, that fails.
inline std::string missing(const std::string& program, const std::string& package)
{
    if (testing::run_program(program, {"--version"}).code == 0)
        return {};
    EXPECT_EQ(std::getenv("LAMBENT_REQUIRE_EMULATORS"), nullptr) << program << " is missing";
    return program + " is missing (package " + package + ")";
}

} // namespace lambent::processors
