#include "apps/report/picture_figures.h"

#include "apps/report/measurements.h"

#include <utility>

namespace lambent::report {
namespace {

struct Pictures {
    std::vector<PagePicture> shots; ///< column by column
    std::vector<PagePicture> references;
};

Pictures pictures_of(ReportContext& context, const FigureData& figure)
{
    Pictures pictures;
    for (const Values& values : axis_values(figure)) {
        const Shot shot = shot_of(context.content, figure, values);
        const Values all = values_of(context.content, figure, values);
        const bool compared = figure.compared && fits(figure.compared->where, values);
        pictures.shots.push_back(compared ? context.compared(shot, fill(figure.compared->name, all))
                                          : context.renderer.picture(shot));
        add_measurements(context, {figure, values, shot}, pictures.shots.back());
        if (!compared || !context.references || !figure.reference || !fits(figure.reference->where, values))
            continue;
        pictures.references.push_back(context.entries.back().comparison.reference);
        pictures.references.back().title = fill(figure.reference->title, all);
    }
    return pictures;
}

std::vector<std::string> titles_of(const Content& content, const FigureData& figure, const Axis& axis)
{
    std::vector<std::string> titles;
    for (const std::string& value : axis.values)
        titles.push_back(fill(axis.title, values_of(content, figure, {{axis.name, value}})));
    return titles;
}

// References are one more column.
Matrix matrix_of(const Content& content, const FigureData& figure, const Pictures& pictures)
{
    Matrix matrix{titles_of(content, figure, figure.rows), titles_of(content, figure, figure.columns), {}};
    if (!pictures.references.empty())
        matrix.columns.push_back(pictures.references.front().title);
    for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
        for (std::size_t column = 0; column < figure.columns.values.size(); ++column)
            matrix.pictures.push_back(pictures.shots.at(column * matrix.rows.size() + row));
        if (!pictures.references.empty())
            matrix.pictures.push_back(pictures.references.at(row));
    }
    return matrix;
}

} // namespace

FigureBody shot_pictures(ReportContext& context, const FigureData& figure)
{
    Pictures pictures = pictures_of(context, figure);
    if (figure.kind == FigureKind::matrix)
        return matrix_of(context.content, figure, pictures);
    pictures.shots.insert(pictures.shots.end(), pictures.references.begin(), pictures.references.end());
    if (figure.kind == FigureKind::comparison)
        return Comparison{std::move(pictures.shots)};
    return Gallery{std::move(pictures.shots)};
}

} // namespace lambent::report
