// What options mean together, once the words of each were taken.
#pragma once

#include "apps/options/arguments.h"

namespace lambent::cli {

/// Makes of what was asked for what is drawn: settings that follow from others.
void derive(RenderArguments& arguments);

/// The same, of a command line. Each throws Error(usage) for what does not go together.
void settle(RenderArguments& arguments, const Given& given);
void settle(ReferenceArguments& arguments, const Given& given);
void settle(BakeArguments& arguments, const Given& given);
void settle(CompareArguments& arguments, const Given& given);
void settle(ReportArguments& arguments, const Given& given);
void settle(StartArguments& arguments, const Given& given);
void settle(CommonOptions& options, const Given& given);

} // namespace lambent::cli
