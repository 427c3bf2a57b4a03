#include "apps/report/content/content.h"

#include "apps/report/content/content_reader.h"
#include "apps/report/content/content_files.h"
#include "base/text.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace lambent::report {
namespace {

std::string_view file_named(std::span<const ContentFile> files, const std::string& name)
{
    for (const ContentFile& file : files)
        if (file.name == name)
            return file.text;
    throw std::logic_error(text("the page's content lacks ", name));
}

bool is_of_pictures(FigureKind kind)
{
    return kind != FigureKind::table && kind != FigureKind::plot;
}

// Whether a pattern depends on an axis, by its placeholder or by one that the axis's list implies.
bool names_axis(const std::string& pattern, const Axis& axis, const Lists& lists)
{
    const auto list = lists.find(axis.name);
    return std::ranges::any_of(placeholders(pattern), [&](const std::string& name) {
        return name == axis.name || (list != lists.end() && list->second.begin()->second.contains(name));
    });
}

void check_shots(const FigureData& figure, const Lists& lists)
{
    if (!figure.shot && figure.shots_of.empty() && figure.curves.empty())
        throw std::logic_error(text("the figure ", figure.id, " has no shots"));
    if (!figure.shot || !is_of_pictures(figure.kind))
        return;
    for (const Axis* axis : {&figure.rows, &figure.columns})
        if (!axis->name.empty() && !names_axis(figure.shot->shot.name, *axis, lists))
            throw std::logic_error(text("the shots of ", figure.id, " do not use {", axis->name, "}"));
}

void check_same_figures(const std::string& section, const SectionWords& words,
                        const std::vector<FigureData>& figures)
{
    std::multiset<std::string> described, shown;
    for (const FigureWords& figure : words.figures)
        described.insert(figure.id);
    for (const FigureData& figure : figures)
        shown.insert(figure.id);
    for (const std::string& id : described)
        if (!shown.contains(id))
            throw std::logic_error(text("the figure ", id, " has words, but figures/", section,
                                        ".json does not say what it shows"));
    for (const std::string& id : shown)
        if (described.count(id) != 1)
            throw std::logic_error(
                text("the figure ", id, " must have words once in words/", section, ".md"));
}

} // namespace

bool fits(const Condition& condition, const Values& values)
{
    return std::ranges::all_of(condition, [&](const auto& entry) {
        const auto found = values.find(entry.first);
        return found != values.end() && std::ranges::find(entry.second, found->second) != entry.second.end();
    });
}

Content::Content(std::span<const ContentFile> files)
    : page_(read_page_data("page.json", file_named(files, "figures/page.json"))),
      lists_(read_lists("lists.json", file_named(files, "figures/lists.json")))
{
    words_["page"] = parse_words("page.md", file_named(files, "words/page.md"));
    for (const std::string& section : page_.sections) {
        const std::string json = text("figures/", section, ".json"), prose = text("words/", section, ".md");
        words_[section] = parse_words(prose, file_named(files, prose));
        const std::vector<FigureData> figures = read_figures(json, file_named(files, json));
        check_same_figures(section, words_[section], figures);
        for (const FigureData& figure : figures) {
            check_shots(figure, lists_);
            if (!figures_.emplace(figure.id, figure).second)
                throw std::logic_error(text("two figures are named ", figure.id));
        }
    }
    for (const auto& [id, figure] : figures_) {
        for (const std::string& other : figure.shots_of)
            if (other != all_compared)
                (void)this->figure(other);
        for (const PlottedCurve& curve : figure.curves)
            (void)this->figure(curve.figure);
    }
}

const SectionWords& Content::words(const std::string& section) const
{
    return words_.at(section);
}

const FigureData& Content::figure(const std::string& id) const
{
    const auto found = figures_.find(id);
    if (found == figures_.end())
        throw std::logic_error(text("there is no figure named ", id));
    return found->second;
}

const std::string& Content::label(const std::string& name) const
{
    return page_.labels.at(name);
}

Values Content::values(const FigureData& figure, const Values& own) const
{
    Values all = own;
    all.insert(figure.values.begin(), figure.values.end());
    all.insert(page_.constants.begin(), page_.constants.end());
    Values fields;
    for (const auto& [name, value] : all) {
        const auto list = lists_.find(name);
        if (list == lists_.end())
            continue;
        const auto entry = list->second.find(value);
        if (entry == list->second.end())
            throw std::logic_error(text("the list ", name, " has no ", value));
        fields.insert(entry->second.begin(), entry->second.end());
    }
    all.insert(fields.begin(), fields.end());
    return all;
}

const Content& built_in_content()
{
    static const Content content(embedded_content);
    return content;
}

std::vector<Values> axis_values(const FigureData& figure)
{
    // A figure without columns is one column.
    const std::vector<std::string> columns =
        figure.columns.name.empty() ? std::vector<std::string>{""} : figure.columns.values;
    std::vector<Values> all;
    for (const std::string& column : columns)
        for (const std::string& row : figure.rows.values) {
            Values values = {{figure.rows.name, row}};
            if (!figure.columns.name.empty())
                values[figure.columns.name] = column;
            all.push_back(std::move(values));
        }
    return all;
}

} // namespace lambent::report
