// The table of options against itself, its help, its manual and the arguments that its words become.
#include "apps/options/option_table.h"
#include "base/error.h"
#include "base/text.h"
#include "tests/cli/option_manual.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace lambent::cli {
namespace {

using Line = std::vector<std::string>;

Arguments parsed(Line words)
{
    words.insert(words.begin(), "lambent");
    std::vector<const char*> pointers;
    pointers.reserve(words.size());
    for (const std::string& word : words)
        pointers.push_back(word.c_str());
    return parse_arguments(static_cast<int>(pointers.size()), pointers.data());
}

std::string printed(const Line& words)
{
    return std::get<PrintText>(parsed(words)).text;
}

std::vector<const Option*> options_of(unsigned command)
{
    std::vector<const Option*> options;
    for (const OptionList& list : option_lists())
        if ((list.commands & command) != 0)
            options.insert(options.end(), list.options.begin(), list.options.end());
    return options;
}

// Words that an option takes: the ends of its range, its choices, and others of its kind.
Line words_for(const Option& option)
{
    const Domain& domain = option.domain;
    switch (domain.kind) {
    case Domain::Kind::flag:
        return {"yes"};
    case Domain::Kind::choice:
        return words_in(domain.choices);
    case Domain::Kind::color:
        return {"0,0.1,1", "1234.5678,1e-7,3"};
    case Domain::Kind::place:
        return {"1,-2,3", "4500000.25,0.1,100000000.125"};
    case Domain::Kind::orbit:
        return {"10,20", "-33.333333,0.1"};
    case Domain::Kind::size:
        return {"64x32", "2048x1024"};
    case Domain::Kind::background:
        return {"env", "none", "blur:0.35", "0.1,0.2,0.30000001"};
    case Domain::Kind::light:
        return {"directional:1,2,3,4,5", "point:1,2,3,4,5,6"};
    case Domain::Kind::text:
        return {"name"};
    default:
        break;
    }
    Line words = words_in(domain.choices);
    for (const double value : {domain.least, domain.most, 1.0, 2.0, 0.1, 0.123456789, 137.0, 1048576.0})
        if (value >= domain.least && value <= domain.most && std::abs(value) < 1e30 &&
            !(domain.above_least && value == domain.least) &&
            (domain.kind != Domain::Kind::whole || value == std::floor(value)))
            words.push_back(word_of_digits(value, 12));
    return words;
}

TEST(Options, NamesAreUniqueAndEveryOptionIsExplained)
{
    for (const CommandRow& row : commands()) {
        std::set<std::string_view> names;
        for (const Option* option : options_of(row.bit)) {
            EXPECT_TRUE(names.insert(option->name).second) << row.name << " --" << option->name;
            EXPECT_FALSE(option->help.empty()) << option->name;
            EXPECT_EQ(option->word.empty(), option->domain.kind == Domain::Kind::flag) << option->name;
        }
    }
}

TEST(Options, HelpListsExactlyWhatACommandTakes)
{
    const std::regex name("\n  (?:-[a-z],)?--([a-z-]+)");
    for (const CommandRow& row : commands()) {
        const std::string help = printed({std::string(row.name), "--help"});
        std::set<std::string> listed, there = {"help"};
        for (std::sregex_iterator i(help.begin(), help.end(), name), end; i != end; ++i)
            listed.insert((*i)[1]);
        for (const Option* option : options_of(row.bit))
            if (option->form != Form::positional)
                there.emplace(option->name);
        listed.insert("help");
        EXPECT_EQ(listed, there) << row.name;
    }
}

template <class T>
struct Table : ::testing::Test {
};
using Tables = ::testing::Types<RenderArguments, ReferenceArguments, BakeArguments, CompareArguments,
                                ReportArguments, ServeArguments, EnvArguments, InfoArguments, CommonOptions>;
TYPED_TEST_SUITE(Table, Tables);

constexpr unsigned everybody = command::all | command::viewers_alone;

TYPED_TEST(Table, DefaultsAreWhatNothingGivenIs)
{
    for_each_row<TypeParam>(everybody, [](const Row<TypeParam>& row) {
        const Option& option = row.option;
        TypeParam arguments;
        const std::string word = row.value.get(arguments, option);
        EXPECT_TRUE(word == option.usual || word.empty()) << option.name << ": " << word;
        if (option.usual.empty())
            return;
        row.value.set(arguments, option,
                      std::string(option.usual)); // throws where it is none of the domain's
        EXPECT_EQ(row.value.get(arguments, option), option.usual) << option.name;
    });
}

TYPED_TEST(Table, WordsBecomeValuesAndTheSameWordsAgain)
{
    for_each_row<TypeParam>(everybody, [](const Row<TypeParam>& row) {
        const Option& option = row.option;
        for (const std::string& word : words_for(option)) {
            TypeParam first, second;
            row.value.set(first, option, word);
            const std::string said = row.value.get(first, option);
            EXPECT_FALSE(said.empty()) << option.name << " " << word;
            row.value.set(second, option, said);
            EXPECT_EQ(row.value.get(second, option), said) << option.name << " " << word;
            if (option.form == Form::repeated)
                continue;
            row.value.set(first, option, "");
            EXPECT_EQ(row.value.get(first, option), row.value.get(TypeParam(), option)) << option.name;
        }
    });
}

// Arguments, the words made of them, and the arguments that a command takes from these. Of options that exclude each other, or
// replace what others say, as --ibl split-sum does, one is left out.
TEST(Options, ArgumentsAreTakenFromTheirWordsAgain)
{
    for (const char* model : {"ggx", "phong"})
        for (const char* scene : {"sphere", "a.glb"}) {
            RenderArguments asked;
            asked.scene = scene;
            Given model_given;
            model_given.add("model", model);
            take(model_given, command::render, asked);
            for_each_row<RenderArguments>(command::render, [&](const Row<RenderArguments>& row) {
                const Option& option = row.option;
                if (option.name != "scene" && option.name != "model" && option.name != "camera-node" &&
                    option.name != "pipeline" && option.name != "camera" && option.name != "ibl" &&
                    option.name != "no-audit" && option.name != "bounces" && option.name != "passes" &&
                    option.name != "error" && option.name != "time" && applies(option.needs, asked))
                    row.value.set(asked, option, words_for(option).back());
            });
            asked.orbit = view::Orbit{0.1f, 0.2f, 3.0f};
            Line line = {"render"};
            for (const OptionWord& word : words_of(asked, command::render))
                append(line, word);
            const RenderArguments taken = std::get<RenderArguments>(parsed(line));
            Line again = {"render"};
            for (const OptionWord& word : words_of(taken, command::render))
                append(again, word);
            EXPECT_EQ(again, line);
            EXPECT_GT(line.size(), 30u);
            EXPECT_EQ(taken.vertical_fov, asked.vertical_fov);
            EXPECT_EQ(taken.settings.environment_rotation, asked.settings.environment_rotation);
            EXPECT_EQ(taken.orbit->azimuth, 0.1f);
            EXPECT_EQ(taken.target, asked.target);
        }
}

TEST(Options, BouncesAreTakenFromTheirWordsAgain)
{
    RenderArguments asked;
    asked.scene = "sphere";
    asked.output = "a.png";
    asked.bounces = 3;
    asked.settings.passes = 3;
    Line line = {"render"};
    for (const OptionWord& word : words_of(asked, command::render))
        append(line, word);
    const RenderArguments taken = std::get<RenderArguments>(parsed(line));
    EXPECT_EQ(taken.settings.bounces, 3);
    EXPECT_EQ(taken.settings.passes, 3);
}

TEST(Options, EveryControlIsAnOptionsWithinItsDomain)
{
    std::set<int> places;
    std::set<std::string_view> without_command;
    for (const OptionList& list : option_lists())
        for (const Option* option : list.options) {
            if (option->place != 0) {
                EXPECT_TRUE(places.insert(option->place).second) << option->name;
            }
            if (option->control.label.empty())
                continue;
            if ((list.commands & command::all) == 0)
                without_command.insert(option->name);
            const Domain::Kind kind = option->domain.kind;
            if (kind == Domain::Kind::number || kind == Domain::Kind::whole || kind == Domain::Kind::angle) {
                EXPECT_NO_THROW(number_of(*option, text(option->control.least))) << option->name;
                EXPECT_NO_THROW(number_of(*option, text(option->control.most))) << option->name;
                EXPECT_LT(option->control.least, option->control.most) << option->name;
            }
        }
    EXPECT_EQ(without_command, std::set<std::string_view>{"layer"}); // viewers' own
    EXPECT_GT(places.size(), 20u);
}

TEST(Options, TheManualsTablesAreTheseOnes)
{
    std::ostringstream page;
    page << std::ifstream(LAMBENT_ROOT "/docs/CLI.md").rdbuf();
    EXPECT_EQ(with_option_tables(page.str()), page.str()) << "./dev options writes them";
}

} // namespace
} // namespace lambent::cli
