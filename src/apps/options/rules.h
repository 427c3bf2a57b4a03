// Rules between options, applied after the words of each were parsed.
#pragma once

#include "apps/options/arguments.h"

namespace lambent::cli {

/// Whether options ask for what only the 2014 report draws, which has no shadows.
bool draws_as_report(const RenderArguments& arguments);

/// Sets the settings that follow from others.
void derive(RenderArguments& arguments);

/// Checks the options of a command line against each other and sets what follows from them. Each throws Error(usage).
void settle(RenderArguments& arguments, const Given& given);
void settle(ReferenceArguments& arguments, const Given& given);
void settle(BakeArguments& arguments, const Given& given);
void settle(CompareArguments& arguments, const Given& given);
void settle(ReportArguments& arguments, const Given& given);
void settle(StartArguments& arguments, const Given& given);
void settle(CommonOptions& options, const Given& given);

} // namespace lambent::cli
