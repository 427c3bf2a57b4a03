// Reads the files of figures/.
#pragma once

#include "apps/report/content/content.h"

#include <string_view>
#include <vector>

namespace lambent::report {

/// Each throws std::logic_error, which names the file and the key, where the text is not JSON, or a key is unknown, is
/// missing or has a value of another type.
PageData read_page_data(std::string_view file, std::string_view json);
Lists read_lists(std::string_view file, std::string_view json);
std::vector<FigureData> read_figures(std::string_view file, std::string_view json);

} // namespace lambent::report
