// The state that the functions which make figures share, and helpers for them.
#pragma once

#include "apps/report/content/content.h"
#include "apps/report/shot_renderer.h"

#include <string>
#include <utility>
#include <vector>

namespace lambent::report {

/// A picture that was compared with its reference.
struct Entry {
    std::string figure; ///< the picture's name in the table of errors
    ReferenceComparison comparison;
};

struct ReportContext {
    const Content& content;
    ShotRenderer& renderer;
    bool references = true; ///< whether pictures are compared with path-traced references
    std::vector<Entry> entries;

    /// Draws a shot. With references it is compared with its own: the error is added to the picture's numbers, and to
    /// `entries` under the name `figure`.
    PagePicture compared(const Shot& shot, const std::string& figure);
};

/// The values of all placeholders of a figure's patterns: Content::values, and {scaled_exposure} where these have
/// {texel_scale}, {texel_power} and {exposure}. It is texel_scale^texel_power * exposure, which has the effect of
/// scaling the texels in a pipeline that raises them to that power.
Values values_of(const Content& content, const FigureData& figure, const Values& own);

/// The figure's shot, filled with values. Throws std::logic_error where the figure has none or a placeholder no value.
Shot shot_of(const Content& content, const FigureData& figure, const Values& own);

/// The same shot with as many samples as its method needs to converge.
Shot converged_shot_of(const Content& content, const FigureData& figure, const Values& own);

/// The mean radiance of surfaces towards the camera, over the pixels that they cover and over the colour channels.
double mean_on_surfaces(const image::RadianceImage& light);

/// The mean saturation of a shot's surfaces as displayed, 0 to 1: see compare::mean_saturation.
double saturation(ShotRenderer& renderer, const Shot& shot);

/// RMS of the difference of two shots' codes, relative to the largest code.
double code_difference(ShotRenderer& renderer, const Shot& a, const Shot& b);

} // namespace lambent::report
