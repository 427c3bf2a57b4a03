#include "apps/report/content/words.h"

#include "base/text.h"

#include <set>
#include <sstream>
#include <stdexcept>

namespace lambent::report {
namespace {

Passage passage_of(const std::string& paragraph)
{
    const std::string_view mark = "{if ", negation = "not ";
    const std::size_t end = paragraph.find("} ");
    if (!paragraph.starts_with(mark) || end == std::string::npos)
        return {"", true, paragraph};
    std::string condition = paragraph.substr(mark.size(), end - mark.size());
    const bool negated = condition.starts_with(negation);
    if (negated)
        condition.erase(0, negation.size());
    return {condition, !negated, paragraph.substr(end + 2)};
}

// The blocks of text between blank lines, each on one line.
std::vector<std::string> paragraphs_of(std::string_view content)
{
    std::vector<std::string> paragraphs(1);
    std::istringstream lines{std::string(content)};
    for (std::string line; std::getline(lines, line);) {
        std::string& last = paragraphs.back();
        if (!line.empty())
            last += text(last.empty() ? "" : " ", line);
        else if (!last.empty())
            paragraphs.emplace_back();
    }
    if (paragraphs.back().empty())
        paragraphs.pop_back();
    return paragraphs;
}

FigureWords figure_heading(std::string_view file, const std::string& line)
{
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos)
        throw std::logic_error(text(file, ": \"", line, "\" is not \"## ID: TITLE\""));
    return {line.substr(3, colon - 3), line.substr(colon + 2), {}};
}

template <class Visit>
void for_each_passage(const SectionWords& words, Visit&& visit)
{
    for (const Passage& passage : words.text)
        visit(passage);
    for (const FigureWords& figure : words.figures)
        for (const Passage& passage : figure.caption)
            visit(passage);
}

template <class Given>
void check_same_names(const char* kind, const std::set<std::string>& used, const Given& given)
{
    for (const auto& [name, value] : given)
        if (!used.contains(name))
            throw std::logic_error(text("no words use the ", kind, " ", name));
    for (const std::string& name : used)
        if (!given.contains(name))
            throw std::logic_error(text("the words use an unknown ", kind, ", ", name));
}

} // namespace

SectionWords parse_words(std::string_view file, std::string_view content)
{
    SectionWords words;
    for (const std::string& paragraph : paragraphs_of(content)) {
        if (paragraph.starts_with("## "))
            words.figures.push_back(figure_heading(file, paragraph));
        else if (paragraph.starts_with("# ") && words.title.empty())
            words.title = paragraph.substr(2);
        else if (words.title.empty() || paragraph.starts_with('#'))
            throw std::logic_error(text(file, ": one title, \"# TITLE\", belongs before all other text"));
        else
            (words.figures.empty() ? words.text : words.figures.back().caption)
                .push_back(passage_of(paragraph));
    }
    return words;
}

std::vector<std::string> filled(const std::vector<Passage>& passages, const Filling& filling)
{
    std::vector<std::string> shown;
    for (const Passage& passage : passages) {
        if (!passage.condition.empty()) {
            const auto found = filling.conditions.find(passage.condition);
            if (found == filling.conditions.end())
                throw std::logic_error(text("unknown condition {if ", passage.condition, "}"));
            if (found->second != passage.wanted)
                continue;
        }
        shown.push_back(fill(passage.pattern, filling.values));
    }
    return shown;
}

std::string caption_of(const FigureWords& figure, const Filling& filling)
{
    std::string caption;
    for (const std::string& part : filled(figure.caption, filling))
        caption += text(caption.empty() ? "" : " ", part);
    return caption;
}

void check_filling(const SectionWords& words, const Filling& filling)
{
    std::set<std::string> values, conditions;
    for_each_passage(words, [&](const Passage& passage) {
        const std::vector<std::string> names = placeholders(passage.pattern);
        values.insert(names.begin(), names.end());
        if (!passage.condition.empty())
            conditions.insert(passage.condition);
    });
    check_same_names("placeholder", values, filling.values);
    check_same_names("condition", conditions, filling.conditions);
}

} // namespace lambent::report
