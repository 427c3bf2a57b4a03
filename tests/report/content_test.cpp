// The words and the shots of the page, before anything is drawn.
#include "apps/report/content/content.h"
#include "apps/report/content/content_files.h"
#include "apps/report/figure_makers.h"
#include "apps/report/shot.h"

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::report {
namespace {

TEST(Pattern, PlaceholdersAreFilled)
{
    EXPECT_EQ(fill("e = {exposure}, {way}{way}", {{"exposure", "7"}, {"way", "a"}}), "e = 7, aa");
    EXPECT_EQ(fill("", {}), "");
    EXPECT_EQ(placeholders("{a} b {c}"), (std::vector<std::string>{"a", "c"}));
}

TEST(Pattern, UnknownPlaceholdersAndLoneBracesAreErrors)
{
    for (const char* pattern : {"{other}", "{", "}", "a {exposure", "{a{exposure}}", "exposure}"})
        EXPECT_THROW(fill(pattern, {{"exposure", "7"}}), std::logic_error) << pattern;
}

const char* const example =
    "# Title\n\nOne\nline of {a}.\n\n{if fine} Two.\n\n## f: Figure: one\n\nCaption.\n\n"
    "{if not fine} More.\n";

TEST(Words, AreParagraphsAndCaptions)
{
    const SectionWords words = parse_words("x.md", example);
    EXPECT_EQ(words.title, "Title");
    ASSERT_EQ(words.figures.size(), 1u);
    EXPECT_EQ(words.figures[0].id, "f");
    EXPECT_EQ(words.figures[0].title, "Figure: one");
    const Filling fine{{{"a", "text"}}, {{"fine", true}}}, other{{{"a", "text"}}, {{"fine", false}}};
    EXPECT_EQ(filled(words.text, fine), (std::vector<std::string>{"One line of text.", "Two."}));
    EXPECT_EQ(filled(words.text, other), (std::vector<std::string>{"One line of text."}));
    EXPECT_EQ(caption_of(words.figures[0], fine), "Caption.");
    EXPECT_EQ(caption_of(words.figures[0], other), "Caption. More.");
}

TEST(Words, MustUseEveryValueAndConditionAndNoOthers)
{
    const SectionWords words = parse_words("x.md", example);
    EXPECT_NO_THROW(check_filling(words, {{{"a", ""}}, {{"fine", true}}}));
    EXPECT_THROW(check_filling(words, {{}, {{"fine", true}}}), std::logic_error);
    EXPECT_THROW(check_filling(words, {{{"a", ""}}, {}}), std::logic_error);
    EXPECT_THROW(check_filling(words, {{{"a", ""}, {"b", ""}}, {{"fine", true}}}), std::logic_error);
    EXPECT_THROW(check_filling(words, {{{"a", ""}}, {{"fine", true}, {"b", true}}}), std::logic_error);
    EXPECT_THROW(filled(words.text, {{}, {{"fine", true}}}), std::logic_error);
    EXPECT_THROW(filled(words.text, {{{"a", ""}}, {}}), std::logic_error);
}

TEST(Words, HaveOneTitleAndNamedFigures)
{
    for (const char* content : {"Text.\n", "# A\n\n# B\n", "# A\n\n### B\n", "# A\n\n## no name\n"})
        EXPECT_THROW(parse_words("x.md", content), std::logic_error) << content;
}

// A small content, of which one file may be another text.
Content content_with(const std::string& name, std::string_view text)
{
    std::vector<ContentFile> files = {
        {"figures/page.json",
         R"({"sections": ["s"], "cover": {"command": "sphere"}, "constants": {}, "labels": {}})"},
        {"figures/lists.json", R"({"way": {"a": {"title": "A"}}})"},
        {"figures/s.json", R"({"f": {"kind": "gallery", "pictures": {"name": "way", "values": ["a"]},
            "shot": {"name": "f-{way}", "command": "sphere"}}})"},
        {"words/page.md", "# P\n"},
        {"words/s.md", "# S\n\n## f: F\n"}};
    for (ContentFile& file : files)
        if (file.name == name)
            file.text = text;
    return Content(files);
}

TEST(Content, FiguresHaveTheValuesOfTheirLists)
{
    const Content content = content_with("", "");
    const FigureData& figure = content.figure("f");
    EXPECT_EQ(axis_values(figure), (std::vector<Values>{{{"way", "a"}}}));
    EXPECT_EQ(content.values(figure, {{"way", "a"}}), (Values{{"way", "a"}, {"title", "A"}}));
    EXPECT_THROW(content.values(figure, {{"way", "b"}}), std::logic_error);
}

TEST(Content, FiguresWithoutShotsOrWordsAreErrors)
{
    // No figure for the words, no words for the figure, words twice, and no shots; then shots with one name.
    EXPECT_THROW(content_with("figures/s.json", "{}"), std::logic_error);
    EXPECT_THROW(content_with("words/s.md", "# S\n"), std::logic_error);
    EXPECT_THROW(content_with("words/s.md", "# S\n\n## f: F\n\n## f: F\n"), std::logic_error);
    EXPECT_THROW(content_with("figures/s.json", R"({"f": {"kind": "gallery"}})"), std::logic_error);
    EXPECT_THROW(content_with("figures/s.json", R"({"f": {"kind": "table", "shots_of": ["g"]}})"),
                 std::logic_error);
    EXPECT_THROW(content_with("figures/s.json", R"({"f": {"kind": "gallery",
        "pictures": {"name": "way", "values": ["a"]}, "shot": {"name": "f", "command": "sphere"}}})"),
                 std::logic_error);
}

TEST(Content, BrokenFilesAreErrors)
{
    for (const char* json : {"", "[]", R"({"f": {"kind": "film", "shot": {"command": "sphere"}}})",
                             R"({"f": {"kind": "gallery", "shot": {"command": "sphere", "colour": "red"}}})",
                             R"({"f": {"kind": "gallery", "shot": {"command": 1}}})",
                             R"({"f": {"kind": "gallery", "shot": {}}})"})
        EXPECT_THROW(content_with("figures/s.json", json), std::logic_error) << json;
}

TEST(Content, MustFitTheProgram)
{
    EXPECT_THROW(check_makers(content_with("", "")), std::logic_error) << "figures are missing";
    EXPECT_NO_THROW(check_makers(built_in_content()));
}

void for_each_shot(const std::function<void(const FigureData&, const Shot&)>& visit)
{
    const Content& content = built_in_content();
    for (const auto& [id, figure] : content.figures())
        if (figure.shot)
            for (const Values& values : axis_values(figure)) {
                visit(figure, shot_of(content, figure, values));
                if (!figure.shot->converged.empty())
                    visit(figure, converged_shot_of(content, figure, values));
            }
}

TEST(BuiltInContent, EveryShotIsACommand)
{
    int shots = 0;
    for_each_shot([&](const FigureData& figure, const Shot& shot) {
        std::istringstream stream(shot.words);
        const Words words{std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
        EXPECT_NO_THROW(parse_render(words)) << figure.id << ": " << shot.words;
        ++shots;
    });
    EXPECT_GT(shots, 80);
}

TEST(BuiltInContent, EveryFileBelongsToOneFigure)
{
    std::map<std::string, std::set<std::string>> figures; // by file
    for_each_shot([&](const FigureData& figure, const Shot& shot) {
        if (!shot.name.empty())
            figures[shot.name].insert(figure.id);
    });
    for (const auto& [name, ids] : figures)
        EXPECT_EQ(ids.size(), 1u) << name;
}

TEST(BuiltInContent, EveryFieldOfItsListsIsUsed)
{
    std::string all;
    std::set<std::string> files;
    for (const ContentFile& file : embedded_content) {
        all += file.text;
        files.insert(std::string(file.name));
    }
    const Content& content = built_in_content();
    std::set<std::string> fields;
    for (const auto& [id, figure] : content.figures())
        for (const Values& values : axis_values(figure))
            for (const auto& [name, value] : values_of(content, figure, values))
                fields.insert(name);
    // These are read by functions, not by patterns.
    for (const char* used : {"texel_power", "texel_scale", "samples"})
        fields.erase(used);
    for (const std::string& field : fields)
        EXPECT_NE(all.find("{" + field + "}"), std::string::npos) << field;
    // Two files for each section, two for the page, and the lists.
    EXPECT_EQ(files.size(), 2 * content.page().sections.size() + 3);
}

} // namespace
} // namespace lambent::report
