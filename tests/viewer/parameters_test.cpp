// The table of parameters, and what is refused.
#include "apps/viewer/view_request.h"
#include "base/error.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace lambent::viewer {
namespace {

using Values = cli::RenderArguments;

// The options of the command that draws a scene with these values.
std::vector<std::string> options_of(const Values& values, const std::string& scene)
{
    ViewRequest request{values, {}};
    request.asked.scene = scene;
    const std::vector<std::string> words = words_of(request);
    return {words.begin() + 6, words.end()}; // behind the scene, its size and the camera
}

std::string refusal(std::string_view name, const std::string& word)
{
    Values values;
    const nlohmann::ordered_json before = to_json(values);
    try {
        set_value(values, name, word);
        return "";
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::usage);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        EXPECT_EQ(to_json(values), before);
        return error.what();
    }
}

TEST(Parameters, NamesAreUniqueAndDefaultsAreValues)
{
    std::set<std::string_view> names;
    for (const Parameter* row : parameters()) {
        EXPECT_TRUE(names.insert(row->option.name).second) << row->option.name;
        EXPECT_EQ(refusal(row->option.name, std::string(row->option.usual)), "");
    }
    EXPECT_TRUE(options_of({}, "sphere").empty());
}

TEST(Parameters, EndsOfRangesAreInAndWhatIsBeyondIsOut)
{
    for (const Parameter* parameter : parameters()) {
        if (kind_of(*parameter) != Kind::number && kind_of(*parameter) != Kind::whole)
            continue;
        const std::string_view name = parameter->option.name;
        const cli::Control& row = parameter->option.control;
        EXPECT_EQ(refusal(name, number_word(row.least)), "");
        EXPECT_EQ(refusal(name, number_word(row.most)), "");
        EXPECT_NE(refusal(name, number_word(row.most * 1.01 + 1.0)), "") << name;
        EXPECT_NE(refusal(name, number_word(row.least - 1.0)), "") << name;
        for (const char* word : {"nan", "inf", "1e999", "x", "1 2", "--help"})
            EXPECT_NE(refusal(name, word), "") << name << " " << word;
    }
}

TEST(Parameters, OnlyWordsOfTheListAreChosen)
{
    EXPECT_EQ(refusal("tone", "agx"), "");
    EXPECT_NE(refusal("tone", "AGX"), "");
    EXPECT_NE(refusal("tone", ""), "");
    EXPECT_NE(refusal("background", "blur:9"), "");
    EXPECT_NE(refusal("samples", "1.5"), "");
    EXPECT_NE(refusal("kd", "1,2"), "");
    EXPECT_NE(refusal("kd", "0,0,2"), "");
    EXPECT_NE(refusal("output", "/etc/passwd"), "");
    EXPECT_LT(refusal(std::string(100000, 'x'), "1").size(), 200u);
    EXPECT_LT(refusal("tone", std::string(100000, 'x')).size(), 300u);
}

TEST(Parameters, OptionsAreThoseThatDiffer)
{
    Values values;
    set_value(values, "exposure", "+2.50");
    set_value(values, "alpha", "30");
    set_value(values, "layer", "normal");
    using Words = std::vector<std::string>;
    EXPECT_EQ(options_of(values, "sphere"), (Words{"--exposure", "2.5"}));
    set_value(values, "model", "phong");
    EXPECT_EQ(options_of(values, "sphere"),
              (Words{"--exposure", "2.5", "--model", "phong", "--alpha", "30"}));
    EXPECT_EQ(options_of(values, "a.glb"), (Words{"--exposure", "2.5", "--model", "phong"}));
}

TEST(Parameters, OneRoughnessIsOfGgxAndMayBeTakenBack)
{
    using Words = std::vector<std::string>;
    Values values;
    set_value(values, "roughness", "0.5");
    EXPECT_EQ(options_of(values, "a.glb"), (Words{"--roughness", "0.5"}));
    set_value(values, "model", "phong");
    EXPECT_EQ(options_of(values, "sphere"), (Words{"--model", "phong"}));
    set_value(values, "model", "ggx");
    set_value(values, "roughness", "");
    EXPECT_EQ(to_json(values), to_json(Values()));
}

TEST(Parameters, RowsApplyWhereTheirOptionsDo)
{
    Values values;
    const auto applying = [&](bool built_in) {
        values.scene = built_in ? "sphere" : "a.glb";
        std::set<std::string_view> names;
        for (const Parameter* row : parameters())
            if (row->option.needs != cli::Needs::nothing && cli::applies(row->option.needs, values))
                names.insert(row->option.name);
        return names;
    };
    using Names = std::set<std::string_view>;
    EXPECT_EQ(applying(true), (Names{"roughness"}));
    EXPECT_EQ(applying(false), (Names{"roughness"}));
    set_value(values, "model", "phong");
    EXPECT_EQ(applying(true), (Names{"alpha", "kd", "ks"}));
    EXPECT_EQ(applying(false), Names());
}

TEST(Parameters, JsonHasEveryRowAndValue)
{
    const nlohmann::ordered_json rows = to_json(parameters()), values = to_json(Values());
    ASSERT_EQ(rows.size(), parameters().size());
    for (const auto& row : rows) {
        EXPECT_EQ(values.at(row.at("name").get<std::string>()), row.at("usual"));
        EXPECT_EQ(row.contains("choices"), row.at("kind") == "choice");
        EXPECT_EQ(row.at("scope") == "ggx", row.at("name") == "roughness");
    }
}

} // namespace
} // namespace lambent::viewer
