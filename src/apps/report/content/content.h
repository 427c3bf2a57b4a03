// The page's words and shots, read from the files of words/ and figures/.
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

/// What belongs to no section: figures/page.json.
struct PageData {
    std::vector<std::string> sections; ///< ids, in order
    Shot cover;
    Values constants; ///< placeholders of every pattern
    Values labels;    ///< names of numbers that belong to no figure
};

/// Further placeholders that a placeholder's value implies, by placeholder and value: figures/lists.json.
using Lists = std::map<std::string, std::map<std::string, Values>>;

class Content {
public:
    /// Reads the files named figures/NAME.json and words/NAME.md. Throws std::logic_error unless each section's
    /// figures are the same in both, and each figure has shots with different names.
    explicit Content(std::span<const ContentFile> files);

    const PageData& page() const { return page_; }
    const SectionWords& words(const std::string& section) const;
    const FigureData& figure(const std::string& id) const;
    const std::map<std::string, FigureData>& figures() const { return figures_; }

    /// A label of PageData::labels.
    const std::string& label(const std::string& name) const;

    /// `own`, the figure's values and the constants (in this order of precedence), and what the lists imply. Throws
    /// std::logic_error for a value that its list lacks.
    Values values(const FigureData& figure, const Values& own) const;

private:
    PageData page_;
    Lists lists_;
    std::map<std::string, SectionWords> words_;
    std::map<std::string, FigureData> figures_;
};

/// The content that is embedded in the program.
const Content& built_in_content();

/// The values of a figure's axes for each of its shots, column by column.
std::vector<Values> axis_values(const FigureData& figure);

} // namespace lambent::report
