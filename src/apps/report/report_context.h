// What the sections of the page are written with.
#pragma once

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
    ShotRenderer& renderer;
    bool references = true; ///< without them no errors
    std::vector<Entry> entries;

    /// Draws a shot, and proves it where there are references: its error goes under the picture and into `entries`.
    PagePicture proven(const Shot& shot, const std::string& figure);
};

/// The sections, in the order of the page. Later ones use what earlier ones have drawn.
Section gallery(ReportContext& context);
Section own_pipeline(ReportContext& context);
Section direct_light(ReportContext& context);
Section diffuse_light(ReportContext& context);
Section background(ReportContext& context);
Section specular_light(ReportContext& context);
Section passes(ReportContext& context);
Section beyond(ReportContext& context);
Section making(const ReportContext& context);

/// The mean of what surfaces send towards the viewer, over all pixels and colours of them.
double mean_on_surfaces(const image::RadianceImage& light);

/// Rows as columns: pictures that are to be compared stand side by side, and as large as few columns leave them.
Matrix transposed(const Matrix& matrix);

/// The report's figures of direct light: three of a sphere at exponent 0.1, a teapot at 20000, a plane at 20.
std::vector<Shot> direct_shots();

/// The report's reflecting sphere on its ground, at an exponent; `levels` is the --mip-level.
Shot reflecting(int exponent, const std::string& levels);
constexpr int reflecting_exponents[] = {1, 625, 15625, 390625};

} // namespace lambent::report
