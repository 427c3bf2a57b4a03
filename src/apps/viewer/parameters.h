// What can be set about a picture while it is looked at: one table, from which values are checked, pages make their
// controls and command lines their options.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::viewer {

enum class Kind {
    number, ///< from least to most
    whole,  ///< the same without fractions
    choice, ///< one of the words in `choices`
    color,  ///< "R,G,B", each from 0 to most
};

/// What a row of the table says something about.
enum class Scope {
    all,          ///< every picture
    ggx,          ///< the model ggx
    phong_shapes, ///< the model phong on built-in shapes
};

/// From the report's darkest picture to its brightest; what --fov takes is a little wider.
constexpr double least_exposure = 1e-3, most_exposure = 1e4, least_fov = 1.0, most_fov = 170.0;

/// A row of the table. Values are words, as on the command line; an empty one is not given, which is a value of those
/// rows whose default it is.
struct Parameter {
    std::string_view
        name; ///< with "--" before it the option of `lambent render`, but for `layer` and `bounces`
    std::string_view label, group;
    Kind kind = Kind::number;
    std::string_view usual; ///< the default
    double least = 0.0, most = 1.0;
    bool logarithmic = false;      ///< how a control is divided
    std::string_view choices = {}; ///< with spaces between them
    Scope scope = Scope::all;

    bool may_be_empty() const { return usual.empty(); }
};

std::span<const Parameter> parameters();

/// One value for each parameter.
class Values {
public:
    /// The defaults.
    Values();

    const std::string& operator[](std::string_view name) const;

    /// Numbers are kept to six digits. Throws Error(usage) with one line if there is no such parameter or the word is
    /// none of its values.
    void set(std::string_view name, const std::string& word);

    /// Whether a row says something about these values' picture of a scene that is built in or not.
    bool applies(const Parameter& row, bool built_in) const;

    /// The options that differ from the defaults, for such a scene.
    std::vector<std::string> options(bool built_in) const;

    bool operator==(const Values&) const = default;

private:
    std::map<std::string, std::string, std::less<>> words_;
};

/// The table with its defaults, for pages: an array of objects.
nlohmann::ordered_json to_json(std::span<const Parameter> rows);

/// The values, for pages: an object of words.
nlohmann::ordered_json to_json(const Values& values);

/// A number as a word of at most six digits.
std::string number_word(double value);

/// The same of a coordinate, to six digits of `scale` where that is less: as many as tell places that far apart.
std::string place_word(double value, double scale);

} // namespace lambent::viewer
