// How every test program starts: with the instructions that LAMBENT_ISA allows, as the programs themselves.
#include "wide/instruction_sets.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <exception>

int main(int count, char** words)
{
    testing::InitGoogleTest(&count, words);
    try {
        lambent::wide::limit_instructions_by_environment();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return RUN_ALL_TESTS();
}
