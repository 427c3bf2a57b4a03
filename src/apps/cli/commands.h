// All commands but report and serve, which have folders of their own. All throw Error.
#pragma once

#include "apps/options/arguments.h"

namespace lambent::cli {

void run(const RenderArguments& arguments);
void run(const BakeArguments& arguments);
void run(const ReferenceArguments& arguments);
void run(const CompareArguments& arguments);
void run(const ViewArguments& arguments);
void run(const EnvArguments& arguments);
void run(const InfoArguments& arguments);

} // namespace lambent::cli
