// Numbers and ids of a page's sections and figures, the same in HTML and in JSON.
#pragma once

#include "apps/report/html.h"
#include "apps/report/page.h"

#include <string>
#include <vector>

namespace lambent::report {

/// The number and the ids of a figure.
struct FigureIds {
    std::string id;       ///< of the figure
    std::string number;   ///< "4.2"; empty for the cover
    std::string title_id; ///< of its heading
    Ids& ids;
};

struct Chapter {
    const Section* section;
    std::string number, id;
    std::vector<FigureIds> figure_ids; ///< of the section's figures
};

/// The page's sections in order. `ids` must outlive the result, whose figures take the ids of their parts from it.
std::vector<Chapter> chapters_of(const Page& page, Ids& ids);

} // namespace lambent::report
