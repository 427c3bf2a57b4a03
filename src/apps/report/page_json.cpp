#include "apps/report/chapters.h"

#include <nlohmann/json.hpp>

namespace lambent::report {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::vector<Number>& numbers)
{
    Json list = Json::array();
    for (const Number& number : numbers)
        list.push_back({{"name", number.name}, {"value", number.value}});
    return list;
}

Json json_of(const PagePicture& picture)
{
    return {{"file", picture.file},
            {"width", picture.width},
            {"height", picture.height},
            {"title", picture.title},
            {"alt", picture.alt},
            {"commands", picture.commands},
            {"numbers", json_of(picture.numbers)}};
}

Json json_of(const std::vector<PagePicture>& pictures)
{
    Json list = Json::array();
    for (const PagePicture& picture : pictures)
        list.push_back(json_of(picture));
    return list;
}

Json json_of(const Gallery& gallery)
{
    return {{"kind", "gallery"}, {"pictures", json_of(gallery.pictures)}};
}

Json json_of(const Matrix& matrix)
{
    return {{"kind", "matrix"},
            {"rows", matrix.rows},
            {"columns", matrix.columns},
            {"pictures", json_of(matrix.pictures)}};
}

Json json_of(const Comparison& comparison)
{
    return {{"kind", "comparison"}, {"pictures", json_of(comparison.pictures)}};
}

Json json_of(const Table& table)
{
    return {{"kind", "table"}, {"columns", table.columns}, {"rows", table.rows}};
}

Json json_of(const Plot& plot)
{
    Json curves = Json::array();
    for (const Curve& curve : plot.curves)
        curves.push_back({{"name", curve.name}, {"x", curve.x}, {"y", curve.y}});
    return {{"kind", "plot"},
            {"x_title", plot.x_title},
            {"y_title", plot.y_title},
            {"alt", plot.alt},
            {"curves", curves}};
}

Json json_of(const Figure& figure, const FigureIds& own)
{
    Json json = {
        {"id", own.id}, {"number", own.number}, {"title", figure.title}, {"caption", figure.caption}};
    json.update(std::visit([](const auto& content) { return json_of(content); }, figure.content));
    return json;
}

Json json_of(const Chapter& chapter)
{
    Json figures = Json::array();
    for (std::size_t i = 0; i < chapter.figure_ids.size(); ++i)
        figures.push_back(json_of(chapter.section->figures[i], chapter.figure_ids[i]));
    return {{"id", chapter.id},
            {"number", chapter.number},
            {"title", chapter.section->title},
            {"text", chapter.section->text},
            {"figures", figures}};
}

} // namespace

std::string to_json(const Page& page)
{
    Json sections = Json::array();
    Ids ids;
    for (const Chapter& chapter : chapters_of(page, ids))
        sections.push_back(json_of(chapter));
    const Json json = {{"title", page.title},
                       {"lead", page.lead},
                       {"cover", json_of(page.cover)},
                       {"sections", sections},
                       {"facts", json_of(page.facts)}};
    // Invalid UTF-8 is replaced by U+FFFD; it is no error.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace lambent::report
