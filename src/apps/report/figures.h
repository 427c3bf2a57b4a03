// The figures of a page as HTML, all but plots.
#pragma once

#include "apps/report/chapters.h"

namespace lambent::report {

std::string figure_html(const Figure& figure, const Place& place);

/// The picture over everything, with its title, numbers and commands.
std::string cover_html(const PagePicture& cover, Ids& ids);

/// A list of names with their values; nothing where there are none.
std::string numbers_html(const std::vector<Number>& numbers);

/// A table that scrolls inside its own box, named by the element `label`.
std::string table_html(const Table& table, const std::string& label);

} // namespace lambent::report
