// The page's words and shots, as the files of words/ and figures/ have them.
#pragma once

#include "apps/report/content/figure_data.h"
#include "apps/report/content/words.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::report {

struct ContentFile;

/// The page but for what is on it: figures/page.json.
struct PageData {
    std::vector<std::string> sections; ///< ids, in order
    Shot cover;
    Values constants; ///< known to every pattern
    Values labels;    ///< of numbers that are not a figure's
};

/// Fields of a placeholder's values, by placeholder and value: figures/lists.json. Where a shot has a value for a
/// placeholder with a list, the fields are placeholders too.
using Lists = std::map<std::string, std::map<std::string, Values>>;

class Content {
public:
    /// Reads the files named figures/NAME.json and words/NAME.md. Throws std::logic_error unless each section's
    /// figures are the same in both, and each figure has shots whose names tell them apart.
    explicit Content(std::span<const ContentFile> files);

    const PageData& page() const { return page_; }
    const SectionWords& words(const std::string& section) const;
    const FigureData& figure(const std::string& id) const;
    const std::map<std::string, FigureData>& figures() const { return figures_; }

    /// A label of PageData::labels.
    const std::string& label(const std::string& name) const;

    /// `own`, the figure's values and the constants (in this order of precedence), with the fields of lists. Throws
    /// std::logic_error for a value that its list lacks.
    Values values(const FigureData& figure, const Values& own) const;

private:
    PageData page_;
    Lists lists_;
    std::map<std::string, SectionWords> words_;
    std::map<std::string, FigureData> figures_;
};

/// The content that the program was built with.
const Content& built_in_content();

/// The values that each shot of a figure has of its axes, column by column.
std::vector<Values> axis_values(const FigureData& figure);

} // namespace lambent::report
