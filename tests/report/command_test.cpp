// `lambent report` as its users meet it: its files, its commands, and what it found.
#include "base/text.h"
#include "image/files/image_io.h"
#include "tests/support/process.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <sstream>

namespace lambent {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::Folder;
using testing::Outcome;

std::string contents(const fs::path& path)
{
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

Outcome report(const std::string& folder, const std::vector<std::string>& words)
{
    std::vector<std::string> all = {"report", "-o", folder};
    all.insert(all.end(), words.begin(), words.end());
    return testing::run_program(LAMBENT_PROGRAM, all, 300.0);
}

// One page for all tests that look at one.
class Report : public ::testing::Test {
protected:
    static void SetUpTestSuite()
    {
        folder = std::make_unique<Folder>();
        // Where sanitizers make it slow, smaller: what is found is found there, too.
        const std::string size = testing::patience > 1 ? "256x144" : "512x288";
        outcome = report(folder->path("out"), {"--quick", "--stats", "json", "--size", size});
        if (outcome.code == 0)
            page = json::parse(contents(folder->path("out/report.json")));
    }
    static void TearDownTestSuite() { folder.reset(); }

    void SetUp() override { ASSERT_EQ(outcome.code, 0) << outcome.error; }

    static std::unique_ptr<Folder> folder;
    static Outcome outcome;
    static json page;
};

std::unique_ptr<Folder> Report::folder;
Outcome Report::outcome;
json Report::page;

void for_each_picture(const json& page, const std::function<void(const json&)>& visit)
{
    visit(page["cover"]);
    for (const json& section : page["sections"])
        for (const json& figure : section["figures"])
            if (figure.contains("pictures"))
                for (const json& picture : figure["pictures"])
                    visit(picture);
}

json picture(const json& page, const std::string& file)
{
    json found;
    for_each_picture(page, [&](const json& picture) {
        if (picture["file"] == file)
            found = picture;
    });
    EXPECT_FALSE(found.is_null()) << file;
    return found;
}

// The number under a picture: "4.23 : 1" is 4.23, "12 %" is 12.
double number(const json& page, const std::string& file, const std::string& name)
{
    const json shown = picture(page, file);
    for (const json& number : shown["numbers"])
        if (number["name"].get<std::string>().find(name) != std::string::npos)
            return std::stod(number["value"].get<std::string>());
    ADD_FAILURE() << file << " has no " << name;
    return 0.0;
}

// Runs a picture's commands, in a folder of their own, and expects the file that the page shows. What they print.
std::string expect_made_by_its_commands(const json& picture, const fs::path& page_folder)
{
    const Folder folder;
    std::string script = text("lambent() { '", LAMBENT_PROGRAM, "' \"$@\"; }\ncd '", folder.path(""), "'");
    for (const json& command : picture["commands"])
        script += text(" && ", command.get<std::string>());
    const Outcome made = testing::run_program("sh", {"-c", script}, 120.0);
    EXPECT_EQ(made.code, 0) << script << "\n" << made.error;
    const std::string file = picture["file"];
    EXPECT_TRUE(contents(folder.path(file)) == contents(page_folder / file))
        << file << " is not what makes " << script;
    return made.output;
}

TEST_F(Report, EveryPictureIsThereAsLargeAsItSays)
{
    std::set<std::string> files = {"index.html", "report.json"};
    for_each_picture(page, [&](const json& picture) {
        const std::string file = picture["file"];
        files.insert(file);
        const image::ImageInfo info = image::inspect(folder->path(text("out/", file)));
        EXPECT_EQ(info.width, picture["width"]) << file;
        EXPECT_EQ(info.height, picture["height"]) << file;
        EXPECT_FALSE(picture["commands"].empty()) << file;
    });
    EXPECT_GT(files.size(), 50u);
    std::set<std::string> there;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder->path("out")))
        there.insert(entry.path().filename().string());
    EXPECT_EQ(there, files);
}

// Of so many pictures one is made again: all of them, but where sanitizers make each command take seconds.
constexpr int made_again = testing::patience > 1 ? 8 : 1;

TEST_F(Report, EveryCommandMakesItsPicture)
{
    int pictures = 0;
    std::set<std::string> seen; // a picture may stand in two places
    for_each_picture(page, [&](const json& picture) {
        if (seen.insert(picture["file"]).second && pictures++ % made_again == 0)
            expect_made_by_its_commands(picture, folder->path("out"));
    });
    EXPECT_GT(pictures, 50);
}

TEST(ReportWithReferences, EveryCommandMakesItsPicture)
{
    const Folder small;
    const Outcome traced = report(small.path("out"), {"--size", "96x54", "--spp", "4", "--noise", "0.2"});
    ASSERT_EQ(traced.code, 0) << traced.error;
    const json small_page = json::parse(contents(small.path("out/report.json")));
    int references = 0, heat_maps = 0;
    std::set<std::string> seen;
    for_each_picture(small_page, [&](const json& picture) {
        const std::string file = picture["file"];
        const bool reference = file.ends_with("-reference.png"), heat = file.ends_with("-error.png");
        if (!seen.insert(file).second || !(reference || heat))
            return;
        references += reference ? 1 : 0;
        heat_maps += heat ? 1 : 0;
        if ((references + heat_maps) % made_again != 0)
            return;
        const std::string said = expect_made_by_its_commands(picture, small.path("out"));
        if (heat) { // what `lambent compare` says, to the two digits that are shown at least
            const double error = 100.0 * json::parse(said)["relative_rmse"].get<double>();
            EXPECT_NEAR(number(small_page, file, "error"), error, 0.05 * error) << file;
        }
    });
    EXPECT_GE(references, 8);
    EXPECT_GE(heat_maps, 20);
}

// A table of the page, by its figure's name; its cells as numbers, of which units follow.
struct Cells {
    json rows;

    double operator()(std::size_t row, std::size_t column) const
    {
        return std::stod(rows[row][column].get<std::string>());
    }
};

Cells cells(const json& page, const std::string& id)
{
    for (const json& section : page["sections"])
        for (const json& figure : section["figures"])
            if (figure["id"] == id)
                return {figure["rows"]};
    return {};
}

// The report's own findings, on the numbers of the page.

TEST_F(Report, LuminanceRisesWithExposureAndHighlightsKeepTheirHue)
{
    for (const std::string series : {"diffuse-linear-", "diffuse-nonlinear-", "background-"}) {
        double before = 0.0;
        for (const std::string exposure : {"0.1", "1", "7", "70", "700", "7000"}) {
            if (exposure == "7000" && series != "background-")
                continue;
            const std::string file = text(series, exposure, ".png");
            const double luminance = number(page, file, "luminance");
            EXPECT_GT(luminance, before) << file;
            before = luminance;
            const json shown = picture(page, file);
            for (const json& found : shown["numbers"]) // only said where some is lost
                EXPECT_NE(found["name"], "hue order kept") << file;
        }
    }
}

TEST_F(Report, LinearColourIsMoreSaturatedAt7And70)
{
    for (const std::string exposure : {"7", "70"})
        EXPECT_GT(number(page, text("diffuse-linear-", exposure, ".png"), "saturation"),
                  number(page, text("diffuse-nonlinear-", exposure, ".png"), "saturation"))
            << exposure;
}

// The captions of the report's sky: a bright wash at 7000, a good exposure at 70, twilight at 1.
TEST_F(Report, ItsOwnPipelineMakesItsCaptionsTrue)
{
    const Cells cell = cells(page, "own-sky-numbers");
    ASSERT_EQ(cell.rows.size(), 6u);
    for (std::size_t row = 1; row < 6; ++row) {
        EXPECT_LT(cell(row, 1), cell(row - 1, 1)); // darker
        EXPECT_GT(cell(row, 2), cell(row - 1, 2)); // and more colourful
    }
    EXPECT_GT(cell(0, 3), 50.0); // blank
    EXPECT_GT(cell(2, 1), 40.0);
    EXPECT_LT(cell(2, 3), 25.0);
    EXPECT_LT(cell(4, 1), 35.0);
    EXPECT_LT(cell(4, 3), 1.0);
    // Ours is blank where the report's is not, for it never raises light to 2.2.
    EXPECT_GT(cell(2, 5), 90.0);
}

// Of five factors on the room's texels the one that is taken: three of four pixels blank at 7000, none at 1.
TEST_F(Report, TheRoomIsAsBrightAsTheCaptionsAsk)
{
    const Cells cell = cells(page, "own-scale");
    ASSERT_EQ(cell.rows.size(), 5u);
    for (std::size_t row = 0; row < 5; ++row)
        EXPECT_EQ(cell(row, 1) >= 75.0 && cell(row, 3) == 0.0, cell(row, 0) == 0.3) << row;
}

// Sums without density send on a half of what their BRDF does, which keeps nearly all of it where the lobe is narrow. The
// curve's place matters where light is bright, and does not where the curve is straight.
TEST_F(Report, ItsOrderAndItsMissingDensityCostWhatTheyDo)
{
    const Cells density = cells(page, "own-density"), order = cells(page, "own-order");
    ASSERT_EQ(density.rows.size(), 4u);
    for (std::size_t row = 0; row < 4; ++row)
        EXPECT_NEAR(density(row, 3), 49.0, 3.0) << row;
    EXPECT_NEAR(density(3, 3), 51.5, 1.0); // a picture ten times as large, with 64 samples at edges, has 51.5
    EXPECT_GT(density(3, 2), 98.0);
    ASSERT_EQ(order.rows.size(), 5u);
    EXPECT_GT(order(0, 2), 30.0);
    EXPECT_LT(order(4, 2), 1.0);
    for (std::size_t row = 0; row < 5; ++row)
        EXPECT_GT(order(row, 1), 5.0) << row;
}

TEST_F(Report, ItsOwnLinearColourIsMoreSaturated)
{
    for (const std::string exposure : {"1", "7", "70", "700"})
        EXPECT_GT(number(page, text("own-diffuse-report-", exposure, ".png"), "saturation"),
                  number(page, text("own-diffuse-nonlinear-", exposure, ".png"), "saturation"))
            << exposure;
}

TEST_F(Report, ItsOwnPlaneShowsBlocks)
{
    EXPECT_GT(number(page, "own-plane-report-15625.png", "blockiness"),
              2.0 * number(page, "own-plane-light-15625.png", "blockiness"));
}

TEST_F(Report, TheHighlightIsAnOval)
{
    EXPECT_GT(number(page, "direct-oval.png", "on the plane"), 2.0);
}

TEST_F(Report, AtExponent1ASphereIsNearlyOneColour)
{
    const double flat = number(page, "specular-1-report.png", "spread");
    EXPECT_LT(flat, 30.0);
    for (const std::string exponent : {"625", "15625", "390625"})
        EXPECT_GT(number(page, text("specular-", exponent, "-report.png"), "spread"), 3.0 * flat) << exponent;
}

TEST_F(Report, TheReportsLevelsShowBlocksAndOursDoNot)
{
    const double report = number(page, "blocks-report.png", "blockiness"),
                 ours = number(page, "blocks-matched.png", "blockiness");
    EXPECT_GT(report, 3.0);
    EXPECT_LT(ours, 0.2 * report);
}

TEST_F(Report, ThePassesAddUp)
{
    EXPECT_LT(number(page, "passes-sum.png", "sum"), 1e-5);
}

TEST_F(Report, StatisticsAreOneObject)
{
    const json stats = json::parse(outcome.output);
    EXPECT_EQ(stats["command"], "report");
    EXPECT_GT(stats["times_ms"]["total"], 0.0);
}

// How it ends.

void expect_refused(const Outcome& outcome, int code)
{
    EXPECT_EQ(outcome.code, code) << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: error: ", 0), 0u) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
}

TEST(ReportEnd, BadInputLeavesNothing)
{
    const Folder folder;
    expect_refused(report(folder.path("a"), {"--env", "none"}), 2);
    expect_refused(report(folder.path("a"), {"--quick", "--spp", "4"}), 2);
    expect_refused(report(folder.path("a"), {"--size", "8x8"}), 2);
    expect_refused(testing::run_program(LAMBENT_PROGRAM, {"report"}), 2);
    expect_refused(report(folder.path("a"), {"--quick", "--env", folder.path("missing.hdr")}), 3);
    std::ofstream(folder.path("broken.hdr")) << "#?RADIANCE\nnot an image\n";
    expect_refused(report(folder.path("a"), {"--quick", "--env", folder.path("broken.hdr")}), 3);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"broken.hdr"});
    expect_refused(report(folder.path("broken.hdr"), {"--quick"}), 5);
    expect_refused(report(folder.path("broken.hdr/inside"), {"--quick"}), 5);
}

TEST(ReportEnd, APanoramaWithAnOddNameStandsInTheCommands)
{
    const Folder folder;
    const std::string name = folder.path("it's a sky.hdr");
    ASSERT_EQ(testing::run_program(LAMBENT_PROGRAM, {"env", "sky", "--size", "64x32", "-o", name}).code, 0);
    const Outcome outcome =
        report(folder.path("out"), {"--quick", "--size", "64x36", "--env", name, "--env-rotation", "90"});
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const json page = json::parse(contents(folder.path("out/report.json")));
    expect_made_by_its_commands(picture(page, "background-7.png"), folder.path("out"));
}

TEST(ReportEnd, InterruptedItLeavesNothing)
{
    const Folder folder;
    const std::string script = text("'", LAMBENT_PROGRAM, "' report -o '", folder.path("out"),
                                    "' & pid=$!; sleep 1.5; kill -TERM $pid; wait $pid");
    EXPECT_EQ(testing::run_program("sh", {"-c", script}).code, 128 + 15);
    EXPECT_TRUE(folder.names().empty());
}

} // namespace
} // namespace lambent
