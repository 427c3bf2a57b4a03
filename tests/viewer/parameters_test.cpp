// The table of parameters, and what is refused.
#include "apps/viewer/parameters.h"
#include "base/error.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace lambent::viewer {
namespace {

std::string refusal(std::string_view name, const std::string& word)
{
    Values values;
    const Values before = values;
    try {
        values.set(name, word);
        return "";
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::usage);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        EXPECT_TRUE(values == before);
        return error.what();
    }
}

TEST(Parameters, NamesAreUniqueAndDefaultsAreValues)
{
    std::set<std::string_view> names;
    for (const Parameter& row : parameters()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(refusal(row.name, std::string(row.usual)), "");
        EXPECT_FALSE(row.label.empty());
    }
    EXPECT_TRUE(Values().options(true).empty());
}

TEST(Parameters, EndsOfRangesAreInAndWhatIsBeyondIsOut)
{
    for (const Parameter& row : parameters()) {
        if (row.kind != Kind::number && row.kind != Kind::whole)
            continue;
        EXPECT_EQ(refusal(row.name, number_word(row.least)), "");
        EXPECT_EQ(refusal(row.name, number_word(row.most)), "");
        EXPECT_NE(refusal(row.name, number_word(row.most * 1.01 + 1.0)), "") << row.name;
        EXPECT_NE(refusal(row.name, number_word(row.least - 1.0)), "") << row.name;
        for (const char* word : {"nan", "inf", "1e999", "x", "1 2", "--help"})
            EXPECT_NE(refusal(row.name, word), "") << row.name << " " << word;
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
    values.set("exposure", "+2.50");
    values.set("alpha", "30");
    values.set("layer", "normal");
    using Words = std::vector<std::string>;
    EXPECT_EQ(values.options(true), (Words{"--exposure", "2.5"}));
    values.set("model", "phong");
    EXPECT_EQ(values.options(true), (Words{"--exposure", "2.5", "--model", "phong", "--alpha", "30"}));
    EXPECT_EQ(values.options(false), (Words{"--exposure", "2.5", "--model", "phong"}));
}

TEST(Parameters, OneRoughnessIsOfGgxAndMayBeTakenBack)
{
    using Words = std::vector<std::string>;
    Values values;
    values.set("roughness", "0.5");
    EXPECT_EQ(values.options(false), (Words{"--roughness", "0.5"}));
    values.set("model", "phong");
    EXPECT_EQ(values.options(true), (Words{"--model", "phong"}));
    values.set("model", "ggx");
    values.set("roughness", "");
    EXPECT_TRUE(values == Values());
}

TEST(Parameters, RowsApplyWhereTheirOptionsDo)
{
    Values values;
    const auto applying = [&](bool built_in) {
        std::set<std::string_view> names;
        for (const Parameter& row : parameters())
            if (row.scope != Scope::all && values.applies(row, built_in))
                names.insert(row.name);
        return names;
    };
    using Names = std::set<std::string_view>;
    EXPECT_EQ(applying(true), (Names{"roughness"}));
    EXPECT_EQ(applying(false), (Names{"roughness"}));
    values.set("model", "phong");
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
