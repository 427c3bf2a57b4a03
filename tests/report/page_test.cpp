// The page as text: nothing hostile gets through, nothing is lost, curves are where their numbers are.
#include "apps/report/html.h"
#include "apps/report/page.h"
#include "apps/report/plot.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <regex>
#include <set>

namespace lambent::report {
namespace {

const std::string hostile = "</title></script><script>alert('1')</script>\" onerror=\"x\" & &lt; 'a'";

std::vector<std::string> all_matches(const std::string& text, const std::string& pattern)
{
    std::vector<std::string> found;
    const std::regex regex(pattern);
    for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i)
        found.push_back((*i)[1].str());
    return found;
}

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++found;
    return found;
}

// The page without its style and its script, which are constant.
std::string body_of(const Page& page)
{
    const std::string html = to_html(page);
    return html.substr(html.find("<body"));
}

// A page with every kind of figure, with `text` in each field that is text.
Page page_of(const std::string& text)
{
    const auto picture = [&](const std::string& file) {
        return PagePicture{file, 64, 32, text, text, {text, "second of " + text}, {{text, text}}};
    };
    const Matrix matrix{{text, text}, {text}, {picture("m1.png"), picture("m2.png")}};
    const Comparison comparison{{picture("c1.png"), picture("c2.png"), picture("c3.png")}};
    const Plot plot{text, text, text, {{text, {1, 10}, {2, 3}}}};
    const Section section{"part",
                          text,
                          {text, text},
                          {{"gallery", text, text, Gallery{{picture("g1.png"), picture("g2.png")}}},
                           {"matrix", text, text, matrix},
                           {"comparison", text, text, comparison},
                           {"table", text, text, Table{{text, text}, {{text, text}}}},
                           {"plot", text, text, plot}}};
    return {text, text, picture("cover.png"), {section, section}, {{text, text}}};
}

TEST(Page, EscapesEveryField)
{
    // As many words, as commands are set word by word.
    const std::string html = to_html(page_of(hostile)), calm = to_html(page_of("five calm words each time"));
    for (const char* part : {"<", ">", "\"", "<script", "</script", "</title>"})
        EXPECT_EQ(count(html, part), count(calm, part)) << part;
    for (const char* part : {" onerror=\"", "alert('", "<script>alert"})
        EXPECT_EQ(count(html, part), 0u) << part;
}

TEST(Page, CommandsStandThereAsTheyWere)
{
    Page page = page_of("calm");
    page.sections.clear();
    page.cover.commands = {"  lambent  render 'a b' -o x.png "};
    const std::string html = body_of(page);
    const std::string code = all_matches(html, "<code>(.*)</code>").at(0);
    EXPECT_EQ(std::regex_replace(code, std::regex("</?span>"), ""),
              "  lambent  render &#39;a b&#39; -o x.png ");
}

TEST(Page, OptionsInSentencesAreNotTorn)
{
    EXPECT_EQ(
        prose("p", "With --mip-level, or -- <--x>."),
        "<p>With <code class=\"option\">--mip-level</code>, or <code class=\"option\">--</code> &lt;<code "
        "class=\"option\">--x</code>&gt;.</p>");
    EXPECT_EQ(prose("p class=\"a\"", ""), "<p class=\"a\"></p>");
}

TEST(Page, HostileNamesStayFilesAndIdsStayIds)
{
    Page page = page_of("calm");
    page.cover.file = "javascript:alert(1)";
    page.sections[0].id = "a\" onclick=\"x";
    std::get<Gallery>(page.sections[0].figures[0].content).pictures[0].file = "//host/a b#c?d%e\".png";
    const std::string html = body_of(page);
    EXPECT_EQ(html.find("javascript:"), std::string::npos);
    EXPECT_EQ(html.find("onclick=\""), std::string::npos);
    EXPECT_NE(html.find("href=\".//host/a%20b%23c%3Fd%25e%22.png\""), std::string::npos);
}

TEST(Page, ControlCharactersAreReplaced)
{
    EXPECT_EQ(escape(std::string("a\0b\x1f\n\t", 6)), "a\uFFFDb\uFFFD\n\t");
    EXPECT_EQ(escape("<&>\"'"), "&lt;&amp;&gt;&quot;&#39;");
}

TEST(Page, ShowsEveryPictureWithItsSizeAndLeadsToIt)
{
    const std::string html = body_of(page_of("calm"));
    for (const std::string file : {"cover", "g1", "g2", "m1", "m2", "c1", "c2", "c3"}) {
        const std::size_t times = file == "cover" ? 1 : 2; // two sections
        EXPECT_EQ(count(html, "<img src=\"" + file + ".png\" alt=\"calm\" width=\"64\" height=\"32\""),
                  times);
        EXPECT_EQ(count(html, "href=\"" + file + ".png\""), times);
    }
    EXPECT_EQ(count(html, "loading=\"lazy\""), count(html, "<img") - 1) << "all but the cover";
}

TEST(Page, IdsAreUniqueAndEveryReferenceIsMet)
{
    const std::string html = body_of(page_of("calm"));
    const std::vector<std::string> list = all_matches(html, " id=\"([^\"]*)\"");
    const std::set<std::string> ids(list.begin(), list.end());
    EXPECT_EQ(ids.size(), list.size());
    for (const char* reference :
         {" href=\"#([^\"]*)\"", " data-made=\"([^\"]*)\"", " aria-labelledby=\"([^\"]*)\""})
        for (const std::string& id : all_matches(html, reference))
            EXPECT_TRUE(ids.contains(id)) << id;
    EXPECT_TRUE(ids.contains("part") && ids.contains("part-2") && ids.contains("gallery-2"));
}

TEST(Page, HeadingsNestWithoutJumps)
{
    int level = 0, first = 0;
    for (const std::string& heading : all_matches(body_of(page_of("calm")), "<h([1-6])[ >]")) {
        const int next = std::stoi(heading);
        EXPECT_LE(next, level + 1);
        first += next == 1;
        level = next;
    }
    EXPECT_EQ(first, 1);
    EXPECT_NE(body_of(page_of("calm")).find("Figure 2.5"), std::string::npos);
}

TEST(Page, AsksNobodyForAnything)
{
    const std::string html = to_html(page_of("calm"));
    for (const char* part : {"http:", "https:", "url(", "@import", "<link rel=\"stylesheet", "<iframe"})
        EXPECT_EQ(html.find(part), std::string::npos) << part;
    for (const std::string& source : all_matches(html, " src=\"([^\"]*)\""))
        EXPECT_TRUE(std::regex_match(source, std::regex("[a-z0-9]+\\.png"))) << source;
}

TEST(Page, SaysTheSameCommandsOnce)
{
    Page page = page_of("calm");
    Gallery& gallery = std::get<Gallery>(page.sections[0].figures[0].content);
    page.sections = {{"s", "s", {}, {{"g", "g", "", gallery}}}};
    EXPECT_EQ(count(body_of(page), "<code><span>calm</span></code>"), 2u) << "the cover's and the other's";
    std::get<Gallery>(page.sections[0].figures[0].content).pictures[1].commands = {"another"};
    EXPECT_EQ(count(body_of(page), "<code><span>calm</span></code>"), 2u);
    EXPECT_EQ(count(body_of(page), "<code><span>another</span></code>"), 1u);
}

TEST(Page, AnEmptyPageIsAPage)
{
    const std::string html = to_html({"Title", "", {}, {}, {}});
    EXPECT_EQ(html.find("<img"), std::string::npos);
    EXPECT_NE(html.find("<h1>Title</h1>"), std::string::npos);
    EXPECT_TRUE(nlohmann::json::accept(to_json({})));
    const Section hollow{"s",
                         "",
                         {},
                         {{"a", "", "", Gallery{}},
                          {"b", "", "", Matrix{}},
                          {"c", "", "", Comparison{}},
                          {"d", "", "", Table{}},
                          {"e", "", "", Plot{}}}};
    EXPECT_FALSE(to_html({"", "", {}, {hollow}, {}}).empty());
}

TEST(Json, HoldsEverythingAsItWas)
{
    const auto json = nlohmann::json::parse(to_json(page_of(hostile)));
    EXPECT_EQ(json["title"], hostile);
    EXPECT_EQ(json["cover"]["file"], "cover.png");
    const auto& figures = json["sections"][1]["figures"];
    ASSERT_EQ(figures.size(), 5u);
    std::vector<std::string> kinds;
    for (const auto& figure : figures) {
        kinds.push_back(figure["kind"]);
        EXPECT_EQ(figure["title"], hostile);
        EXPECT_EQ(figure["caption"], hostile);
        for (const auto& picture : figure.value("pictures", nlohmann::json::array())) {
            EXPECT_EQ(picture["width"], 64);
            EXPECT_EQ(picture["commands"], (std::vector<std::string>{hostile, "second of " + hostile}));
            EXPECT_EQ(picture["numbers"][0]["name"], hostile);
            EXPECT_EQ(picture["numbers"][0]["value"], hostile);
        }
    }
    EXPECT_EQ(kinds, (std::vector<std::string>{"gallery", "matrix", "comparison", "table", "plot"}));
    EXPECT_EQ(figures[1]["number"], "2.2");
    EXPECT_EQ(figures[1]["rows"].size(), 2u);
    EXPECT_EQ(figures[3]["rows"][0][1], hostile);
    EXPECT_EQ(figures[4]["curves"][0]["y"], (std::vector<double>{2, 3}));
    EXPECT_EQ(json["facts"][0]["value"], hostile);
}

TEST(Json, NamesFiguresAsThePageDoes)
{
    const Page page = page_of("calm");
    const std::string html = body_of(page);
    const auto json = nlohmann::json::parse(to_json(page));
    for (const auto& section : json["sections"]) {
        EXPECT_EQ(count(html, "<section id=\"" + section["id"].get<std::string>() + "\""), 1u);
        for (const auto& figure : section["figures"])
            EXPECT_EQ(count(html, "<figure id=\"" + figure["id"].get<std::string>() + "\""), 1u);
    }
    EXPECT_EQ(json["sections"][1]["id"], "part-2");
}

TEST(Json, SurvivesWhatIsNotUnicodeAndNotANumber)
{
    Page page{"\xff\xfe", "", {}, {}, {}};
    page.sections = {{"s", "", {}, {{"p", "", "", Plot{"", "", "", {{"", {1}, {NAN}}}}}}}};
    const auto json = nlohmann::json::parse(to_json(page));
    EXPECT_TRUE(json["sections"][0]["figures"][0]["curves"][0]["y"][0].is_null());
}

struct Point {
    double x, y;
};

std::vector<Point> points_of(const std::string& text)
{
    std::vector<Point> points;
    for (const std::string& pair : all_matches(text, "([-0-9.]+,[-0-9.]+)"))
        points.push_back({std::stod(pair), std::stod(pair.substr(pair.find(',') + 1))});
    return points;
}

// Where the labels of an axis stand, by their numbers, from the drawing alone.
std::vector<Point> labels_of(const std::string& svg, const std::string& axis)
{
    const std::regex label("<text class=\"tick " + axis +
                           "\" x=\"([-0-9.]+)\" y=\"([-0-9.]+)\">([0-9.]+)</text>");
    std::vector<Point> labels;
    for (std::sregex_iterator i(svg.begin(), svg.end(), label), end; i != end; ++i)
        labels.push_back({std::stod((*i)[3].str()),
                          axis == "x" ? std::stod((*i)[1].str()) : std::stod((*i)[2].str()) - 4.5});
    return labels;
}

// Where a number belongs, told by the first and the last label.
double place(const std::vector<Point>& labels, double value)
{
    const Point &a = labels.front(), &b = labels.back();
    return a.y + (b.y - a.y) * std::log(value / a.x) / std::log(b.x / a.x);
}

TEST(Plot, CurvesLieWhereTheirNumbersSay)
{
    const Curve curve{"c", {1, 3, 20, 640}, {0.5, 0.07, 0.02, 0.003}};
    const std::vector<std::string> drawings =
        all_matches(plot_html({"x", "y", "alt", {curve}}), "(<svg class=\"plot[^\\0]*?</svg>)");
    ASSERT_EQ(drawings.size(), 2u);
    for (const std::string& svg : drawings) {
        const std::vector<Point> x = labels_of(svg, "x"), y = labels_of(svg, "y");
        ASSERT_GE(x.size(), 2u);
        ASSERT_GE(y.size(), 2u);
        EXPECT_LT(x.front().y, x.back().y) << "to the right";
        EXPECT_GT(y.front().y, y.back().y) << "upwards";
        const std::vector<Point> points = points_of(all_matches(svg, "points=\"([^\"]*)\"").at(0));
        ASSERT_EQ(points.size(), curve.x.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_NEAR(points[i].x, place(x, curve.x[i]), 0.05);
            EXPECT_NEAR(points[i].y, place(y, curve.y[i]), 0.05);
        }
        EXPECT_EQ(count(svg, "<title>c: 3, 0.07</title>"), 1u);
    }
}

TEST(Plot, CurvesBreakWhereThereIsNothingToShow)
{
    const Curve curve{"c", {1, 2, 3, 4, 5}, {1, 2, 0, 4, std::numeric_limits<double>::infinity()}};
    const std::string html = plot_html({"x", "y", "alt", {curve}});
    const std::string drawing = html.substr(html.find("<svg class=\"plot"));
    const std::vector<std::string> lines = all_matches(drawing, "points=\"([^\"]*)\"");
    ASSERT_EQ(lines.size(), 4u) << "two in each of the two drawings";
    EXPECT_EQ(points_of(lines[0]).size(), 2u);
    EXPECT_EQ(points_of(lines[1]).size(), 1u);
    EXPECT_EQ(html.find("nan"), std::string::npos);
    EXPECT_EQ(html.find("inf"), std::string::npos);
}

TEST(Plot, AxesHoldTheirValuesAndEndOnRoundOnes)
{
    const LogAxis axis = axis_of({0.0034, 0, -1, NAN, 7.9});
    EXPECT_DOUBLE_EQ(axis.least, 0.002);
    EXPECT_DOUBLE_EQ(axis.most, 10);
    EXPECT_DOUBLE_EQ(axis.position(0.002), 0);
    EXPECT_DOUBLE_EQ(axis.position(10), 1);
    for (const LogAxis& other : {axis_of({}), axis_of({5}), axis_of({1e-300, 1e300}), axis_of({100, 100})})
        EXPECT_LT(other.least, other.most);
}

TEST(Plot, TicksNameDecadesAndNeverCrowd)
{
    for (const double most : {2.0, 10.0, 1e3, 1e6, 1e12, 1e40})
        for (const int room : {6, 12}) {
            int named = 0;
            for (const Tick& tick : ticks_of({1, most}, room))
                named += !tick.label.empty();
            EXPECT_GE(named, 2) << most;
            EXPECT_LE(named, room + 2) << most;
        }
    std::vector<std::string> labels;
    for (const Tick& tick : ticks_of({1e-5, 1e4}, 12))
        labels.push_back(tick.label);
    std::erase(labels, "");
    EXPECT_EQ(labels, (std::vector<std::string>{"10⁻⁵", "10⁻⁴", "0.001", "0.01", "0.1", "1", "10", "100",
                                                "1000", "10⁴"}));
}

TEST(Plot, NumbersShareTheirRows)
{
    const Table table =
        plotted_numbers({"n", "y", "", {{"a", {1, 2}, {10, 20}}, {"b", {2, 3}, {0.5, 0.25}}}});
    EXPECT_EQ(table.columns, (std::vector<std::string>{"n", "a", "b"}));
    EXPECT_EQ(table.rows, (std::vector<std::vector<std::string>>{
                              {"1", "10", ""}, {"2", "20", "0.5"}, {"3", "", "0.25"}}));
}

} // namespace
} // namespace lambent::report
