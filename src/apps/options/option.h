// One option of the command line: all that parsing, help, manual, viewers' controls and tests know of it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::cli {

/// The commands, as bits of a set.
namespace command {
constexpr unsigned render = 1 << 0, bake = 1 << 1, reference = 1 << 2, compare = 1 << 3, report = 1 << 4,
                   view = 1 << 5, serve = 1 << 6, env = 1 << 7, info = 1 << 8;
constexpr unsigned all = (1 << 9) - 1, of_scenes = render | reference | view | serve;
constexpr unsigned viewers_alone = 1 << 9; ///< no command: options that only the controls of viewers set
} // namespace command

struct CommandRow {
    std::string_view name;
    unsigned bit;
    std::string_view help;
};

/// All commands, in the order of the help.
std::span<const CommandRow> commands();

/// The values that an option takes. Numbers are finite, of magnitude at most 3e38.
struct Domain {
    enum class Kind {
        flag,
        text,   ///< any text; `choices` are the built-in names
        number, ///< from `least` to `most`
        whole,  ///< a whole number in that range; the word in `choices`, if any, stands for least - 1
        angle,  ///< a number of degrees, modulo 360
        choice, ///< one of `choices`
        color,  ///< R,G,B, none below 0
        place,  ///< X,Y,Z in metres
        orbit,  ///< AZ,EL[,DIST]
        size,   ///< WxH
        background,
        light
    };
    Kind kind = Kind::text;
    double least = -3.0e38, most = 3.0e38;
    bool above_least = false;      ///< `least` itself is excluded
    std::string_view choices = {}; ///< separated by spaces
};

constexpr Domain flag{Domain::Kind::flag, 0, 0, false, {}};
constexpr Domain any_number{Domain::Kind::number};
constexpr Domain not_negative{Domain::Kind::number, 0.0};

constexpr Domain above_zero(double most = 3.0e38)
{
    return {Domain::Kind::number, 0.0, most, true, {}};
}

constexpr Domain number(double least, double most)
{
    return {Domain::Kind::number, least, most, false, {}};
}

constexpr Domain whole(double least, double most, std::string_view word_below = {})
{
    return {Domain::Kind::whole, least, most, false, word_below};
}

constexpr Domain one_of(std::string_view choices)
{
    return {Domain::Kind::choice, 0, 0, false, choices};
}

/// Any text, such as a file name; `names` are built in.
constexpr Domain any_text(std::string_view names = {})
{
    return {Domain::Kind::text, 0, 0, false, names};
}

/// The control with which viewers set an option.
struct Control {
    std::string_view label = {}, group = {}; ///< no label: no control
    double least = 0.0, most = 0.0;          ///< range of numbers and of colour components
    bool logarithmic = false;                ///< scale of the slider
    std::string_view choices = {};           ///< offered, separated by spaces; none: all of the domain's
};

/// What an option needs to have an effect.
enum class Needs {
    nothing,
    ggx,          ///< the shading model ggx
    phong_shapes, ///< the shading model phong on built-in shapes
    shapes,       ///< built-in shapes
    file          ///< a scene from a file
};

enum class Form {
    option,     ///< "--name WORD"; the last one counts
    joined,     ///< the same; commands are written with "--name=WORD", as the word may look like an option
    repeated,   ///< any number of times
    required,   ///< must be given
    positional, ///< must be given, without its name
};

struct Option {
    std::string_view name = {}; ///< without dashes
    std::string_view word = {}; ///< name of the value in the help; none: a flag
    Domain domain = {};
    std::string_view usual = {};   ///< the default's word; none: not set
    std::string_view usually = {}; ///< description of the default, in place of its word
    std::string_view help = {};
    std::string_view manual = {}; ///< text of docs/CLI.md, in place of the help
    Form form = Form::option;
    char letter = 0; ///< "-o"
    Needs needs = Needs::nothing;
    /// Position among viewers' controls, and among the options after the camera's in a viewer's command; 0: in neither.
    int place = 0;
    Control control = {};
};

/// "--name"
std::string dashed(const Option& option);

/// The help text, followed by the default.
std::string help_of(const Option& option);

/// The description of the default, or its word.
std::string_view default_of(const Option& option);

/// Splits text at spaces.
std::vector<std::string> words_in(std::string_view choices);

/// Options under one heading in the help of the same commands.
struct OptionList {
    std::string_view heading;
    unsigned commands = 0;
    std::vector<const Option*> options;
};

/// All options, in the order of the help.
const std::vector<OptionList>& option_lists();

} // namespace lambent::cli
