#include "apps/report/chapters.h"

#include <utility>

namespace lambent::report {

std::vector<Chapter> chapters_of(const Page& page, Ids& ids)
{
    // Ids of the page itself.
    for (const char* own : {"top", "text", "facts", "viewer", "viewer-title", "said"})
        ids.take(own);
    std::vector<Chapter> chapters;
    for (const Section& section : page.sections) {
        Chapter chapter{&section, std::to_string(chapters.size() + 1), ids.take(section.id), {}};
        for (const Figure& figure : section.figures) {
            const std::string number = chapter.number + "." + std::to_string(chapter.figure_ids.size() + 1);
            const std::string id = ids.take(figure.id);
            chapter.figure_ids.push_back({id, number, ids.take(id + "-title"), ids});
        }
        chapters.push_back(std::move(chapter));
    }
    return chapters;
}

} // namespace lambent::report
