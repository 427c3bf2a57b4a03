// The page of figures: words and shots of the content, drawn and measured.
#pragma once

#include "apps/report/report_context.h"

namespace lambent::report {

/// The whole page but its facts. Figures of references are left out where the context has none. Throws
/// std::logic_error where the content does not fit the program, before anything is drawn.
Page make_page(ReportContext& context);

} // namespace lambent::report
