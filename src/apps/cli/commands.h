// What each command does. All throw Error; those that return a number return the exit code.
#pragma once

#include "apps/cli/arguments.h"

namespace lambent::cli {

void run(const RenderArguments& arguments);
void run(const ReferenceArguments& arguments);
int run(const CompareArguments& arguments);
void run(const EnvArguments& arguments);
void run(const InfoArguments& arguments);

} // namespace lambent::cli
