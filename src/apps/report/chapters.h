// The parts of a page with their numbers and the names they are found by: the same in HTML and in JSON.
#pragma once

#include "apps/report/html.h"
#include "apps/report/page.h"

#include <string>
#include <vector>

namespace lambent::report {

/// Where a figure stands on the page, and the names its parts take.
struct Place {
    std::string id;       ///< of the figure
    std::string number;   ///< "4.2"; empty for the cover
    std::string title_id; ///< of its heading
    Ids& ids;
};

struct Chapter {
    const Section* section;
    std::string number, id;
    std::vector<Place> places; ///< of the section's figures
};

/// The page's sections in order. `ids` must live as long, and goes on naming smaller parts.
std::vector<Chapter> chapters_of(const Page& page, Ids& ids);

} // namespace lambent::report
