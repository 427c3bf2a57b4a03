// A figure's shots and measurements, as read from figures/*.json.
#pragma once

#include "apps/report/content/pattern.h"

#include <optional>
#include <string>
#include <vector>

namespace lambent::report {

/// One picture of the page and the command that draws it.
struct Shot {
    std::string name;  ///< file name, without ".png" but with ".jpg"
    std::string words; ///< arguments of `lambent render` before -o, separated by spaces
    std::string title; ///< as PagePicture's
    std::string alt;   ///< as PagePicture's
    bool lit = true;   ///< whether the page's environment lights it; otherwise none does
};

/// Patterns of a figure's shots.
struct ShotPattern {
    Shot shot;             ///< its texts are patterns
    std::string converged; ///< pattern of the words that draw the shot converged; may be empty
};

/// The values of one placeholder. There is a row, a column or a picture for each.
struct Axis {
    std::string name;
    std::vector<std::string> values;
    std::string title; ///< pattern of a row's or column's title
};

/// The allowed values by placeholder. An empty condition holds for every shot.
using Condition = std::map<std::string, std::vector<std::string>>;

/// Whether each placeholder of the condition has one of its allowed values.
bool fits(const Condition& condition, const Values& values);

/// A number under a picture.
struct Measurement {
    std::string quantity; ///< as in measurements.h
    std::string name;     ///< on the page
    Condition where;
};

/// The shots that are compared with a reference.
struct ComparedShots {
    std::string name; ///< pattern of the name in the table of errors
    Condition where;
};

/// The references that are shown beside the shots.
struct ShownReferences {
    std::string title; ///< pattern
    Condition where;
};

/// A curve of a plot, measured in a shot of another figure.
struct PlottedCurve {
    std::string name, figure;
    Values values;
};

enum class FigureKind { gallery, matrix, comparison, table, plot };

struct FigureData {
    std::string id;
    FigureKind kind = FigureKind::gallery;
    bool references = false; ///< whether the figure needs references; a page without them leaves it out
    Values values;           ///< the same for all shots
    Axis rows;               ///< of a matrix, a table or a plot; the pictures of other figures
    Axis columns;            ///< of a matrix
    std::optional<ShotPattern> shot;   ///< empty where the figure only measures shots of others
    std::vector<std::string> shots_of; ///< ids of the figures whose shots are measured; or all_compared
    std::optional<ComparedShots> compared;
    std::optional<ShownReferences> reference;
    std::vector<Measurement> measured;
    std::vector<std::string> titles; ///< of a table's columns, of a plot's axes
    std::string alt;                 ///< of a plot
    std::vector<PlottedCurve> curves;
};

/// In FigureData::shots_of: every shot of the page that is compared with a reference.
inline constexpr const char* all_compared = "all compared";

} // namespace lambent::report
