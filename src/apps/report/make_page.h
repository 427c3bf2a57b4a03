// Makes the page of figures: draws and measures the content's shots and fills its words.
#pragma once

#include "apps/report/report_context.h"

namespace lambent::report {

/// The whole page but its facts. Figures that need references are left out where the context has none. Throws
/// std::logic_error where content and program do not match.
Page make_page(ReportContext& context);

} // namespace lambent::report
