// Figures of a page as HTML. Plots are in plot.h.
#pragma once

#include "apps/report/chapters.h"

namespace lambent::report {

std::string figure_html(const Figure& figure, const FigureIds& own);

/// The picture at the top of the page, with its title, numbers and commands.
std::string cover_html(const PagePicture& cover, Ids& ids);

/// A list of names with their values; empty if `numbers` is.
std::string numbers_html(const std::vector<Number>& numbers);

/// A table in a scrolling box; `label` is the id of the element that names it.
std::string table_html(const Table& table, const std::string& label);

} // namespace lambent::report
