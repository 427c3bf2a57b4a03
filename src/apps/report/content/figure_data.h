// What a figure shows, as its section's file in figures/ says: which shots, and what is measured in them.
#pragma once

#include "apps/report/content/pattern.h"

#include <optional>
#include <string>
#include <vector>

namespace lambent::report {

/// One picture of the page, named by the command that draws it.
struct Shot {
    std::string name;  ///< of its file, without ".png"; or with ".jpg"
    std::string words; ///< of `lambent render` between that and -o, apart by spaces: "sphere --model phong"
    std::string title; ///< as PagePicture's
    std::string alt;   ///< as PagePicture's
    bool lit = true;   ///< by the report's environment; else by none
};

/// Patterns of a figure's shots.
struct ShotPattern {
    Shot shot; ///< every text of it a pattern
    std::string
        limit; ///< pattern of the words with which a shot is drawn as exactly as its method can; may be empty
};

/// Values of one placeholder, for each of which there is a row, a column or a picture.
struct Axis {
    std::string name;
    std::vector<std::string> values;
    std::string title; ///< pattern of a row's or column's title
};

/// What a shot's values must be: for each placeholder one of several. Without entries every shot fits.
using Condition = std::map<std::string, std::vector<std::string>>;

bool fits(const Condition& condition, const Values& values);

/// A number under a picture.
struct Measurement {
    std::string quantity; ///< as in measurements.h
    std::string name;     ///< on the page
    Condition where;
};

/// Which shots are compared with a reference, and what the table of errors calls them: a pattern.
struct ProvenShots {
    std::string name;
    Condition where;
};

/// The references that are shown with the shots.
struct ShownReferences {
    std::string title; ///< pattern
    Condition where;
};

/// A curve of a plot: of another figure's shot.
struct PlottedCurve {
    std::string name, figure;
    Values values;
};

enum class FigureKind { gallery, matrix, comparison, table, plot };

struct FigureData {
    std::string id;
    FigureKind kind = FigureKind::gallery;
    bool references = false;           ///< the figure is left out of a page without references
    Values values;                     ///< the same for all shots
    Axis rows;                         ///< of a matrix, a table or a plot; of other figures the pictures
    Axis columns;                      ///< of a matrix
    std::optional<ShotPattern> shot;   ///< without one the figure takes those of others
    std::vector<std::string> shots_of; ///< ids of the figures whose shots are measured; or all_proven
    std::optional<ProvenShots> proven;
    std::optional<ShownReferences> reference;
    std::vector<Measurement> measured;
    std::vector<std::string> titles; ///< of a table's columns, of a plot's axes
    std::string alt;                 ///< of a plot
    std::vector<PlottedCurve> curves;
};

/// In FigureData::shots_of: every shot of the page that is compared with a reference.
inline constexpr const char* all_proven = "all proven";

} // namespace lambent::report
