#include "apps/report/report_context.h"

#include "base/text.h"
#include "compare/appearance.h"

#include <cmath>
#include <stdexcept>

namespace lambent::report {
namespace {

Shot filled_shot(const FigureData& figure, const std::string& words, const Values& values)
{
    const Shot& pattern = figure.shot->shot;
    return {fill(pattern.name, values), words, fill(pattern.title, values), fill(pattern.alt, values),
            pattern.lit};
}

const ShotPattern& pattern_of(const FigureData& figure)
{
    if (!figure.shot)
        throw std::logic_error(text("the figure ", figure.id, " has no shots of its own"));
    return *figure.shot;
}

} // namespace

PagePicture ReportContext::compared(const Shot& shot, const std::string& figure)
{
    PagePicture picture = renderer.picture(shot);
    if (!references)
        return picture;
    ReferenceComparison comparison = renderer.compare_with_reference(shot);
    picture.numbers.push_back({content.label("error"), percent(comparison.error)});
    picture.numbers.push_back({content.label("noise"), noise_text(comparison.noise)});
    entries.push_back({figure, std::move(comparison)});
    return picture;
}

Values values_of(const Content& content, const FigureData& figure, const Values& own)
{
    Values values = content.values(figure, own);
    const auto scale = values.find("texel_scale"), power = values.find("texel_power"),
               exposure = values.find("exposure");
    if (scale != values.end() && power != values.end() && exposure != values.end())
        values["scaled_exposure"] = rounded(
            std::pow(std::stod(scale->second), std::stod(power->second)) * std::stod(exposure->second), 4);
    return values;
}

Shot shot_of(const Content& content, const FigureData& figure, const Values& own)
{
    const Values values = values_of(content, figure, own);
    return filled_shot(figure, fill(pattern_of(figure).shot.words, values), values);
}

Shot converged_shot_of(const Content& content, const FigureData& figure, const Values& own)
{
    Values values = values_of(content, figure, own);
    values["command"] = fill(pattern_of(figure).shot.words, values);
    if (figure.shot->converged.empty())
        throw std::logic_error(text("the shots of ", figure.id, " have no \"converged\""));
    return filled_shot(figure, fill(figure.shot->converged, values), values);
}

double mean_on_surfaces(const image::RadianceImage& light)
{
    double sum = 0.0, covered = 0.0;
    for (std::size_t i = 0; i < light.values.size(); i += 4) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            sum += static_cast<double>(light.values[i + channel]) / 3.0;
        covered += static_cast<double>(light.values[i + 3]);
    }
    return sum / covered;
}

double saturation(ShotRenderer& renderer, const Shot& shot)
{
    return compare::mean_saturation(renderer.codes(shot), renderer.frame(shot).radiance);
}

double code_difference(ShotRenderer& renderer, const Shot& a, const Shot& b)
{
    return compare::code_difference(renderer.codes(a), renderer.codes(b));
}

} // namespace lambent::report
