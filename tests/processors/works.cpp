#include "tests/processors/works.h"

#include "image/files/image_io.h"
#include "wide/instruction_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace lambent::processors {
namespace {

// One column more than 64x36: the last tile is so small that even its first packet of rays is a short one.
constexpr const char* size = "65x36";

// Emulators take their time, and more beside other tests.
constexpr double limit_seconds = 900.0;

void append(const std::string& path, Values& values)
{
    const image::RadianceImage image = image::read_radiance(path);
    values.insert(values.end(), image.values.begin(), image.values.end());
}

image::RadianceImage panorama()
{
    image::RadianceImage image{16, 8, 3, {}};
    image.values.resize(16 * 8 * 3);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            float* const rgb = image.pixel(x, y);
            const float across = static_cast<float>(x) / 16.0f, down = static_cast<float>(y) / 8.0f;
            rgb[0] = 0.3f + 0.4f * across, rgb[1] = 0.8f - 0.5f * down, rgb[2] = 1.0f - 0.7f * down;
            if (x == 4 && y == 2)
                rgb[0] = 120.0f, rgb[1] = 110.0f, rgb[2] = 90.0f;
        }
    return image;
}

} // namespace

Runner limited_to(const std::string& instruction_set)
{
    return {"env", std::string(wide::limit_variable) + "=" + instruction_set};
}

testing::Outcome run(const Runner& runner, const std::vector<std::string>& words)
{
    Runner all = runner;
    all.emplace_back(LAMBENT_PROGRAM);
    all.insert(all.end(), words.begin(), words.end());
    return testing::run_program(all.front(), {all.begin() + 1, all.end()}, limit_seconds);
}

Workshop::Workshop()
{
    image::write_radiance(panorama(), path("light.hdr"));
}

std::vector<std::string> Workshop::words(const std::string& command, const std::string& output) const
{
    const std::string panorama_file = path("light.hdr"), to = path(output);
    if (command == "bake")
        return {"bake",         panorama_file, "-o",       to,    "--size",    "8",   "--lut",  "8",
                "--irradiance", "4",           "--format", "exr", "--backend", "cpu", "--quiet"};
    const bool light_too = command == "light";
    std::vector<std::string> words = {light_too ? "render" : command,
                                      "report",
                                      "--env",
                                      panorama_file,
                                      "--size",
                                      size,
                                      "-o",
                                      to,
                                      "--threads",
                                      "1",
                                      "--density",
                                      "0.1",
                                      "--backend",
                                      "cpu",
                                      "--quiet"};
    if (light_too)
        words.insert(words.end(), {"--bounces", "3", "--passes", "1", "--no-audit"});
    else if (command == "render")
        words.insert(words.end(), {"--bounces", "0"});
    if (light_too || command == "render")
        words.insert(words.end(), {"--no-cache", "--samples", "8"});
    else
        words.insert(words.end(), {"--spp", "1", "--bounces", "2"});
    return words;
}

// The picture that a command writes.
Values Workshop::written(const Runner& runner, const std::string& command) const
{
    const testing::Outcome outcome = run(runner, words(command, command + ".exr"));
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    Values values;
    if (outcome.code == 0)
        append(path(command + ".exr"), values);
    return values;
}

Values Workshop::picture(const Runner& runner) const
{
    return written(runner, "render");
}

Values Workshop::light(const Runner& runner) const
{
    return written(runner, "light");
}

Values Workshop::trace(const Runner& runner) const
{
    return written(runner, "reference");
}

Values Workshop::bake(const Runner& runner) const
{
    const testing::Outcome outcome = run(runner, words("bake", "baked"));
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    std::vector<std::string> names;
    if (outcome.code == 0)
        for (const auto& entry : std::filesystem::directory_iterator(path("baked")))
            if (entry.path().extension() == ".exr")
                names.push_back(entry.path().string());
    std::sort(names.begin(), names.end());
    Values values;
    for (const std::string& name : names)
        append(name, values);
    return values;
}

double distance(const Values& a, const Values& b)
{
    if (a.size() != b.size() || b.empty())
        return 1.0;
    double difference = 0.0, size = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double x = a[i], y = b[i];
        difference += (x - y) * (x - y);
        size += y * y;
    }
    return std::sqrt(difference / size);
}

double share_beyond(const Values& a, const Values& b, double bound)
{
    if (a.size() != b.size() || b.empty())
        return 1.0;
    double mean = 0.0;
    for (const float value : b)
        mean += std::fabs(static_cast<double>(value)) / static_cast<double>(b.size());
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double x = a[i], y = b[i];
        beyond += std::fabs(x - y) <= bound * std::max({std::fabs(x), std::fabs(y), mean}) ? 0 : 1;
    }
    return static_cast<double>(beyond) / static_cast<double>(a.size());
}

} // namespace lambent::processors
