// One option of the command line: all that its help, its parsing, the viewers' controls, the manual and the tests say of it.
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
constexpr unsigned viewers_alone = 1 << 9; ///< no command: what only the controls of viewers set
} // namespace command

struct CommandRow {
    std::string_view name;
    unsigned bit;
    std::string_view help;
};

/// All commands, in the order of the help.
std::span<const CommandRow> commands();

/// The words that an option takes. Numbers are finite, of at most 3e38.
struct Domain {
    enum class Kind {
        flag,
        text,   ///< anything; `choices` are some of it
        number, ///< from `least` to `most`
        whole,  ///< the same without fractions; the word in `choices`, if any, stands for least - 1
        angle,  ///< a number of degrees; whole turns say nothing
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
    bool above_least = false;      ///< `least` itself is none
    std::string_view choices = {}; ///< with spaces between them
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

/// Any text, such as a file's name; some of it are the names of what is built in.
constexpr Domain any_text(std::string_view names = {})
{
    return {Domain::Kind::text, 0, 0, false, names};
}

/// How viewers let an option be set.
struct Control {
    std::string_view label = {}, group = {}; ///< no label: they do not
    double least = 0.0, most = 0.0;          ///< of numbers and of colours' parts
    bool logarithmic = false;                ///< how a slider is divided
    std::string_view choices = {};           ///< to choose from, with spaces; none: all of the domain's
};

/// What an option says something about.
enum class Needs {
    nothing,
    ggx,          ///< the model ggx
    phong_shapes, ///< the model phong on built-in shapes
    shapes,       ///< built-in shapes
    file          ///< a scene that is none of them
};

enum class Form {
    option, ///< "--name WORD", of which the last counts
    joined, ///< the same, written "--name=WORD" where a command is made, as the word may look like an option
    repeated,   ///< any number of times
    required,   ///< must be given
    positional, ///< must be given, without its name
};

struct Option {
    std::string_view name = {}; ///< without dashes
    std::string_view word = {}; ///< what the help calls its value; none: a flag
    Domain domain = {};
    std::string_view usual = {};   ///< the default's word; none: nothing is given
    std::string_view usually = {}; ///< said of the default instead of its word
    std::string_view help = {};
    std::string_view manual = {}; ///< what docs/CLI.md says instead of the help
    Form form = Form::option;
    char letter = 0; ///< "-o"
    Needs needs = Needs::nothing;
    /// The order of viewers' controls and of the options behind the camera's in a viewer's command; 0: in neither.
    int place = 0;
    Control control = {};
};

/// "--name"
std::string dashed(const Option& option);

/// The help's text: with the default.
std::string help_of(const Option& option);

/// What is said of the default: its word, or what stands for that.
std::string_view default_of(const Option& option);

/// The words between spaces.
std::vector<std::string> words_in(std::string_view choices);

/// Options that stand under one heading in the help of the same commands.
struct OptionList {
    std::string_view heading;
    unsigned commands = 0;
    std::vector<const Option*> options;
};

/// All there are, in the order of the help.
const std::vector<OptionList>& option_lists();

} // namespace lambent::cli
