// The prose of a section: its title, its paragraphs and its figures' titles and captions.
#pragma once

#include "apps/report/content/pattern.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::report {

/// A paragraph, with placeholders. "{if NAME} ..." and "{if not NAME} ..." are shown depending on a condition.
struct Passage {
    std::string condition; ///< empty: always shown
    bool wanted = true;    ///< the value of the condition for which it is shown
    std::string pattern;
};

struct FigureWords {
    std::string id, title;
    std::vector<Passage> caption; ///< joined by spaces
};

struct SectionWords {
    std::string title;
    std::vector<Passage> text;
    std::vector<FigureWords> figures; ///< in the order of the page
};

/// Measured values for the placeholders and conditions of a section's words.
struct Filling {
    Values values;
    std::map<std::string, bool> conditions;
};

/// Reads "# TITLE", paragraphs, and for each figure "## ID: TITLE" and its caption's paragraphs. Blank lines end
/// paragraphs; other line breaks are spaces. Throws std::logic_error that names the file.
SectionWords parse_words(std::string_view file, std::string_view content);

/// The passages that are shown, filled. Throws std::logic_error for an unknown placeholder or condition.
std::vector<std::string> filled(const std::vector<Passage>& passages, const Filling& filling);

/// The caption of a figure, filled. Throws as filled() does.
std::string caption_of(const FigureWords& figure, const Filling& filling);

/// Throws std::logic_error unless the words use exactly the values and conditions of the filling. Passages that are not
/// shown count as well.
void check_filling(const SectionWords& words, const Filling& filling);

} // namespace lambent::report
