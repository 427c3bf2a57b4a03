// What the figures of the page are made with.
#pragma once

#include "apps/report/content/content.h"
#include "apps/report/shot_renderer.h"

#include <string>
#include <utility>
#include <vector>

namespace lambent::report {

/// A figure's picture and how far it was found to be from its reference.
struct Entry {
    std::string figure; ///< as it is named in the table
    Proof proof;
};

struct ReportContext {
    const Content& content;
    ShotRenderer& renderer;
    bool references = true; ///< without them no errors
    std::vector<Entry> entries;

    /// Draws a shot, and proves it where there are references: its error goes under the picture and into `entries`.
    PagePicture proven(const Shot& shot, const std::string& figure);
};

/// Everything that a figure's patterns may name: Content::values, and {scaled_exposure} where the values have
/// {texel_scale}, {texel_power} and {exposure}: the exposure by a pipeline that raises texels to a power, of texels
/// taken that many times as bright. A factor on the exposure does it, for a power of a product is the product of
/// powers.
Values values_of(const Content& content, const FigureData& figure, const Values& own);

/// The figure's shot of values. Throws std::logic_error where the figure has none or a placeholder no value.
Shot shot_of(const Content& content, const FigureData& figure, const Values& own);

/// The same shot as its method draws it with as many samples as can matter.
Shot limit_of(const Content& content, const FigureData& figure, const Values& own);

/// The mean of what surfaces send towards the viewer, over all pixels and colours of them.
double mean_on_surfaces(const image::RadianceImage& light);

/// How saturated a shot's colours are, as displayed: 0 to 1.
double saturation(ShotRenderer& renderer, const Shot& shot);

/// RMS of the difference of two shots' codes, relative to the largest code.
double code_difference(ShotRenderer& renderer, const Shot& a, const Shot& b);

} // namespace lambent::report
