#include "apps/report/make_page.h"

#include "apps/report/figure_makers.h"
#include "base/text.h"
#include "compare/appearance.h"

#include <algorithm>
#include <map>

namespace lambent::report {
namespace {

// Lists the exposures at which linear colour is the more saturated one, and the others.
Filling own_filling(ReportContext& context)
{
    const FigureData& charts = context.content.figure("own-diffuse");
    std::string more, less;
    for (const std::string& exposure : charts.rows.values) {
        const auto in = [&](const char* way) {
            return saturation(context.renderer,
                              shot_of(context.content, charts, {{"exposure", exposure}, {"way", way}}));
        };
        std::string& list = in("report") > in("nonlinear") ? more : less;
        list += text(list.empty() ? "" : ", ", exposure);
    }
    return {
        {{"more", more}, {"less", less}, {"texel_scale", context.content.page().constants.at("texel_scale")}},
        {{"always_more", less.empty()},
         {"sometimes_more", !more.empty() && !less.empty()},
         {"never_more", more.empty()}}};
}

// Tells whether linear colour is the more saturated one at 7 and at 70, as the report found.
Filling diffuse_filling(ReportContext& context)
{
    const FigureData& figure = context.content.figure("diffuse-exposures");
    const auto in = [&](const char* space, const char* exposure) {
        return saturation(context.renderer,
                          shot_of(context.content, figure, {{"space", space}, {"exposure", exposure}}));
    };
    const auto more = [&](const char* exposure) {
        return in("linear", exposure) > in("nonlinear", exposure);
    };
    return {{}, {{"linear_wins", more("7") && more("70")}}};
}

// Tells whether each exposure, the highest first, shows more light than the next.
Filling background_filling(ReportContext& context)
{
    const FigureData& figure = context.content.figure("background-exposures");
    bool falls = true;
    double before = 2.0;
    for (const Values& values : axis_values(figure)) {
        const Shot shot = shot_of(context.content, figure, values);
        const double luminance = compare::displayed_luminance(context.renderer.codes(shot));
        falls = falls && luminance < before;
        before = luminance;
    }
    return {{}, {{"luminance_falls", falls}}};
}

Filling beyond_filling(ReportContext& context)
{
    return {{}, {{"quick", !context.references}}};
}

Filling making_filling(ReportContext& context)
{
    const ShotRendererSettings& settings = context.renderer.settings();
    return {{{"noise", percent(settings.noise)}, {"samples", text(settings.samples)}},
            {{"references", context.references}}};
}

// Fillings by section. The words of other sections have no placeholders.
const std::map<std::string, Filling (*)(ReportContext&)> fillings = {{"own", own_filling},
                                                                     {"diffuse", diffuse_filling},
                                                                     {"background", background_filling},
                                                                     {"beyond", beyond_filling},
                                                                     {"making", making_filling}};

// The figures of a section, by id. Those that show all compared shots are made last.
std::map<std::string, FigureBody> bodies_of(ReportContext& context, const SectionWords& words)
{
    std::map<std::string, FigureBody> bodies;
    for (const bool last : {false, true})
        for (const FigureWords& figure : words.figures) {
            const FigureData& data = context.content.figure(figure.id);
            const bool of_compared = std::ranges::find(data.shots_of, all_compared) != data.shots_of.end();
            if (of_compared == last && (context.references || !data.references))
                bodies.emplace(figure.id, figure_body(context, data));
        }
    return bodies;
}

Section section_of(ReportContext& context, const std::string& id)
{
    const SectionWords& words = context.content.words(id);
    std::map<std::string, FigureBody> bodies = bodies_of(context, words);
    const auto found = fillings.find(id);
    const Filling filling = found == fillings.end() ? Filling() : found->second(context);
    check_filling(words, filling);
    Section section{id, words.title, filled(words.text, filling), {}};
    for (const FigureWords& figure : words.figures)
        if (const auto body = bodies.find(figure.id); body != bodies.end())
            section.figures.push_back(
                {figure.id, figure.title, caption_of(figure, filling), std::move(body->second)});
    return section;
}

} // namespace

Page make_page(ReportContext& context)
{
    check_makers(context.content);
    const SectionWords& words = context.content.words("page");
    Page page;
    page.title = words.title;
    page.lead = filled(words.text, {}).at(0);
    page.cover = context.renderer.picture(context.content.page().cover);
    for (const std::string& section : context.content.page().sections)
        page.sections.push_back(section_of(context, section));
    return page;
}

} // namespace lambent::report
