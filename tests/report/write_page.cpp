// Writes a page with every kind of figure, and pictures that are drawn here. write_page FOLDER
#include "apps/report/page.h"
#include "base/error.h"
#include "image/files/image_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <utility>

namespace lambent::report {
namespace {

namespace fs = std::filesystem;

// A row of balls under a lamp and a sky.
struct View {
    int width = 640, height = 480;
    int balls = 1;
    double exposure = 1, roughness = 0.3, metal = 0;
};

using Light = std::array<double, 3>;

struct Vector {
    double x, y, z;
};

double dot(const Vector& a, const Vector& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Light sky(double height)
{
    const double t = std::clamp(height * 0.5 + 0.5, 0.0, 1.0);
    return {0.10 + 0.30 * t, 0.08 + 0.40 * t, 0.07 + 0.62 * t};
}

Light ball_light(const Vector& normal, const View& view, int ball)
{
    const Vector lamp{-0.48, 0.62, 0.62};
    const double facing = std::max(dot(normal, lamp), 0.0);
    const Vector half{-0.267, 0.345, 0.9};
    const double power = 2 / std::max(std::pow(view.roughness, 4), 1e-4);
    const double gloss = std::pow(std::max(dot(normal, half), 0.0), power) * (power + 8) * 0.02;
    const Light paint{0.75 - 0.13 * ball, 0.30 + 0.05 * ball, 0.12 + 0.14 * ball};
    const double edge = std::pow(1 - normal.z, 5);
    Light light = sky(normal.y);
    for (std::size_t c = 0; c < 3; ++c) {
        const double matte = paint[c] * (light[c] * 0.5 + facing * 1.6) * (1 - view.metal);
        const double tint = std::lerp(0.04 + 0.96 * edge, paint[c], view.metal);
        light[c] = matte + tint * (light[c] * (1.4 - view.roughness) + gloss);
    }
    return light;
}

Light light_at(const View& view, double x, double y)
{
    const double radius = 0.86 / std::max(1, view.balls) * view.width / view.height;
    const double ball_radius = std::min(radius, 0.72);
    for (int ball = 0; ball < view.balls; ++ball) {
        const double middle = (2.0 * ball + 1 - view.balls) * ball_radius * 1.15;
        const double dx = (x - middle) / ball_radius, dy = y / ball_radius;
        if (dx * dx + dy * dy < 1)
            return ball_light({dx, dy, std::sqrt(1 - dx * dx - dy * dy)}, view, ball);
    }
    Light light = sky(y - 0.3);
    for (double& channel : light)
        channel *= 0.45 * std::exp(-0.25 * x * x);
    return light;
}

image::CodeImage draw(const View& view)
{
    image::CodeImage picture{view.width, view.height, 3, 8, {}};
    for (int row = 0; row < view.height; ++row)
        for (int column = 0; column < view.width; ++column) {
            const double x = (2.0 * column + 1 - view.width) / view.height;
            const double y = (view.height - 2.0 * row - 1) / view.height;
            for (const double channel : light_at(view, x, y)) {
                const double shown = 1 - std::exp(-channel * view.exposure);
                picture.bytes.push_back(static_cast<std::uint8_t>(255 * std::pow(shown, 1 / 2.2) + 0.5));
            }
        }
    return picture;
}

// Draws the picture and says what is in it.
class Painter {
public:
    explicit Painter(fs::path folder) : folder_(std::move(folder)) {}

    PagePicture paint(const View& view, const std::string& title) const
    {
        ++count_;
        const std::string file = "picture-" + std::to_string(count_) + (count_ % 3 == 0 ? ".jpg" : ".png");
        image::write_codes(draw(view), folder_ / file);
        char exposure[32], roughness[32];
        std::snprintf(exposure, sizeof exposure, "%g", view.exposure);
        std::snprintf(roughness, sizeof roughness, "%.2f", view.roughness);
        PagePicture picture{file, view.width, view.height, title, "Balls under a lamp: " + title, {}, {}};
        picture.commands = {"lambent bake studio.hdr --format ktx2 --samples 1024 -o build/baked",
                            "lambent render balls --environment build/baked --roughness " +
                                std::string(roughness) + " --exposure " + exposure +
                                " --size 640x480 -o build/report/" + file};
        picture.numbers = {{"exposure", exposure}, {"relative error", "1." + std::to_string(count_) + " %"}};
        return picture;
    }

private:
    fs::path folder_;
    mutable int count_ = 0;
};

Section light_section(const Painter& painter)
{
    Gallery exposures, one, wide;
    for (const double exposure : {0.25, 1.0, 4.0, 7000.0}) {
        char title[32];
        std::snprintf(title, sizeof title, "e = %g", exposure);
        exposures.pictures.push_back(painter.paint({.exposure = exposure}, title));
    }
    one.pictures.push_back(painter.paint({.width = 1200, .height = 600, .balls = 3}, "Three balls"));
    for (int i = 0; i < 5; ++i)
        wide.pictures.push_back(
            painter.paint({.width = 512, .height = 256, .balls = 2 + i % 3, .roughness = 0.1 + 0.15 * i},
                          "Panorama " + std::to_string(i + 1)));
    return {
        "light",
        "Light and exposure",
        {"A surface under a wide sky is lit from every side at once. What arrives is gathered once, before "
         "anything is drawn, and looked up for each pixel afterwards: that is the whole of image based "
         "lighting.",
         "The exposure decides which part of it a display can show. It is applied to the light, before the "
         "tone "
         "curve, so that nothing that was drawn has to be drawn again."},
        {{"exposures", "One picture, four exposures",
          "The same light at four exposures. At the last one nothing is left but white, as on film.",
          exposures},
         {"three-balls", "Paint, clay and plastic", "A single picture takes the width of the text.", one},
         {"panoramas", "Five panoramas", "Pictures twice as wide as high.", wide}}};
}

Section surface_section(const Painter& painter)
{
    Matrix matrix{{"dielectric", "half", "metal"}, {}, {}};
    const std::array<double, 5> roughness{0.1, 0.25, 0.4, 0.6, 0.9};
    for (const double r : roughness)
        matrix.columns.push_back("roughness " + std::to_string(r).substr(0, 4));
    for (int row = 0; row < 3; ++row)
        for (const double r : roughness) {
            PagePicture picture =
                painter.paint({.width = 256, .height = 256, .roughness = r, .metal = row * 0.5}, "a ball");
            picture.numbers.pop_back();
            picture.title.clear();
            matrix.pictures.push_back(picture);
        }
    Comparison two, many;
    two.pictures = {painter.paint({.width = 960, .height = 540, .balls = 3}, "Drawn"),
                    painter.paint({.width = 960, .height = 540, .balls = 3, .roughness = 0.6}, "Reference")};
    for (const double r : {0.1, 0.3, 0.5, 0.9})
        many.pictures.push_back(
            painter.paint({.roughness = r, .metal = 1}, "r = " + std::to_string(r).substr(0, 3)));
    return {"surfaces",
            "Surfaces",
            {"Roughness widens the reflection, and metal colours it."},
            {{"matrix", "Roughness and metal", "Rows are metalness, columns are roughness.", matrix},
             {"two", "Drawn against the reference", "Move the line over the picture.", two},
             {"four", "Any two of four", "Choose what lies left and right of the line.", many}}};
}

Section number_section()
{
    const Table table{{"scene", "pixels", "time", "relative error", "note"},
                      {{"balls", "307 200", "0.42 s", "1.3 %", "as in figure 1.1"},
                       {"kitchen", "921 600", "3.10 s", "0.8 %", "the built-in room, from the island"},
                       {"grid", "65 536", "0.07 s", "—", "no reference yet"}}};
    Plot errors{
        "samples", "relative error", "Errors fall with the samples: three curves, the reference fastest", {}};
    const std::array<std::pair<const char*, double>, 6> kinds{{{"uniform", 0.9},
                                                               {"cosine", 0.5},
                                                               {"of the light", 0.2},
                                                               {"of both", 0.1},
                                                               {"stratified", 0.04},
                                                               {"blurred first", 0.02}}};
    for (const auto& [name, start] : kinds) {
        Curve curve{name, {}, {}};
        for (double samples = 1; samples <= 4096; samples *= 4) {
            curve.x.push_back(samples);
            curve.y.push_back(start / std::pow(samples, name[0] == 's' ? 0.75 : 0.5) + 0.0004);
        }
        errors.curves.push_back(curve);
    }
    const Plot times{"threads",
                     "seconds",
                     "Time falls with threads",
                     {{"this machine", {1, 2, 4, 8}, {8.1, 4.2, 2.3, 1.6}}}};
    return {"numbers",
            "Numbers",
            {"Everything shown above was also measured."},
            {{"times", "Time and error", "Means of five runs.", table},
             {"errors", "Error against samples", "Both axes are logarithmic.", errors},
             {"threads", "Time against threads", "Less than a decade.", times}}};
}

Page sample(const fs::path& folder)
{
    const Painter painter(folder);
    Page page{
        "Light that was there before the picture",
        "A sample of the pages that the report writes: every kind of figure, with pictures drawn by the "
        "program that tests it. Nothing here is measured.",
        {},
        {},
        {}};
    page.cover = painter.paint({.width = 1600, .height = 800, .balls = 5, .roughness = 0.25},
                               "Five balls under one lamp");
    page.sections = {light_section(painter), surface_section(painter), number_section()};
    page.facts = {
        {"version", "0.1.0"}, {"processor", "8 threads, AVX2"}, {"time for all pictures", "12.4 s"}};
    return page;
}

void write(const fs::path& path, const std::string& text)
{
    std::ofstream file(path, std::ios::binary);
    file << text;
    if (!file.flush())
        throw Error(Failure::cannot_write, path.string());
}

} // namespace
} // namespace lambent::report

int main(int count, char** arguments)
try {
    if (count != 2)
        return 2;
    const std::filesystem::path folder = arguments[1];
    std::filesystem::create_directories(folder);
    const lambent::report::Page page = lambent::report::sample(folder);
    lambent::report::write(folder / "index.html", to_html(page));
    lambent::report::write(folder / "report.json", to_json(page));
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "write_page: %s\n", error.what());
    return 1;
}
