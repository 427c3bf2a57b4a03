// `lambent bake` as its users meet it: what its files hold, how it is refused, what it leaves when it fails.
#include "tests/cli/lambent.h"
#include "tests/image/cube_reader.h"

#include "base/file.h"
#include "image/cube/cube_files.h"
#include "image/files/image_io.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <sstream>

namespace lambent {
namespace {

namespace fs = std::filesystem;
using test::CubeFile;
using testing::Folder;
using testing::Outcome;

constexpr double pi = std::numbers::pi;

Outcome bake(const std::string& environment, const std::string& output,
             const std::vector<std::string>& more = {"--size", "8"})
{
    std::vector<std::string> words = {"bake", environment, "-o", output};
    words.insert(words.end(), more.begin(), more.end());
    return lambent(words);
}

Outcome baked(const std::string& environment, const std::string& output,
              const std::vector<std::string>& more = {"--size", "8"})
{
    Outcome outcome = bake(environment, output, more);
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    return outcome;
}

CubeFile read_cube(const std::string& path)
{
    const std::vector<std::uint8_t> bytes = read_file(path);
    return bytes.at(0) == 'D' ? test::read_dds(bytes) : test::read_ktx2(bytes);
}

std::vector<double> numbers_in(const std::string& words)
{
    std::istringstream in(words.substr(0, words.find('\0')));
    std::vector<double> numbers;
    for (double number; in >> number;)
        numbers.push_back(number);
    return numbers;
}

// All entries of a folder, hidden ones too.
std::vector<std::string> entries(const std::string& folder)
{
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

nlohmann::json json_in(const std::string& path)
{
    const std::vector<std::uint8_t> bytes = read_file(path);
    return nlohmann::json::parse(bytes.begin(), bytes.end());
}

// Radiance 1 + d / 2, red by x, green by y, blue by z: its coefficients are known in closed form.
std::string write_gradient(const Folder& folder)
{
    constexpr int width = 128, height = 64;
    image::RadianceImage light{width, height, 3, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double phi = ((x + 0.5) / width - 0.5) * 2.0 * pi, theta = (y + 0.5) / height * pi;
            for (const double d :
                 {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)})
                light.values.push_back(static_cast<float>(1.0 + 0.5 * d));
        }
    image::write_radiance(light, folder.path("gradient.exr"));
    return folder.path("gradient.exr");
}

using Triple = std::array<double, 3>;

// The mean of a face of level 0.
Triple mean(const test::Face& face)
{
    Triple sum{};
    for (const test::Texel& texel : face)
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += texel[c] / static_cast<double>(face.size());
    return sum;
}

void expect_near(const Triple& found, const Triple& wanted, double tolerance)
{
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c], wanted[c], tolerance) << c;
}

TEST(Bake, OneFileIsTheSpecularCube)
{
    const Folder folder;
    const Outcome outcome = baked("furnace", folder.path("a.ktx2"), {"--size", "16"});
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 5);
    EXPECT_EQ(outcome.output.rfind("level 0: 16x16, roughness 0.0000, error 0.000 %\n", 0), 0u)
        << outcome.output;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.ktx2"});
    const CubeFile cube = read_cube(folder.path("a.ktx2"));
    EXPECT_EQ(cube.format, 97u); // four halfs
    EXPECT_EQ(cube.scheme, 0u);
    EXPECT_EQ(cube.size, 16u);
    ASSERT_EQ(cube.levels.size(), 5u);
    for (const auto& level : cube.levels)
        for (const test::Face& face : level)
            for (const test::Texel& texel : face)
                for (const double value : texel)
                    ASSERT_NEAR(value, 1.0, 1e-3);
}

TEST(Bake, TheFileTellsItsRoughnessAndIrradiance)
{
    const Folder folder;
    baked("furnace", folder.path("a.ktx2"), {"--size", "16"});
    const CubeFile cube = read_cube(folder.path("a.ktx2"));
    EXPECT_EQ(cube.metadata.at("KTXwriter").rfind("lambent ", 0), 0u);
    EXPECT_EQ(cube.metadata.at("lambent.roughness"), std::string("0 0.25 0.5 0.75 1") + '\0');
    EXPECT_FALSE(cube.metadata.contains("lambent.mirrored"));
    const std::vector<double> sh = numbers_in(cube.metadata.at("lambent.sh"));
    ASSERT_EQ(sh.size(), 27u);
    // Irradiance pi everywhere: pi over the first harmonic, and nothing else.
    for (std::size_t i = 0; i < 27; ++i)
        EXPECT_NEAR(sh[i], i < 3 ? pi / std::sqrt(1.0 / (4.0 * pi)) : 0.0, 1e-4) << i;
}

TEST(Bake, CoefficientsOfAGradient)
{
    const Folder folder;
    baked(write_gradient(folder), folder.path("a.ktx2"));
    const std::vector<double> sh = numbers_in(read_cube(folder.path("a.ktx2")).metadata.at("lambent.sh"));
    ASSERT_EQ(sh.size(), 27u);
    // The clamped cosine takes a linear function times 2 pi / 3; harmonics 1, 2 and 3 are y, z and x.
    const double linear = 2.0 * pi / 3.0 * 0.5 / std::sqrt(3.0 / (4.0 * pi));
    for (std::size_t i = 0; i < 9; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const bool own = (c == 0 && i == 3) || (c == 1 && i == 1) || (c == 2 && i == 2);
            const double wanted = i == 0 ? pi / std::sqrt(1.0 / (4.0 * pi)) : own ? linear : 0.0;
            EXPECT_NEAR(sh[3 * i + c], wanted, 0.02) << i << ' ' << c;
        }
}

TEST(Bake, FacesLookWhereTheySay)
{
    const Folder folder;
    const std::string gradient = write_gradient(folder);
    baked(gradient, folder.path("a.ktx2"), {"--size", "64", "--texels", "float"});
    baked(gradient, folder.path("m.ktx2"), {"--size", "64", "--texels", "float", "--mirrored"});
    baked(gradient, folder.path("r.ktx2"), {"--size", "64", "--texels", "float", "--env-rotation", "450"});
    const CubeFile cube = read_cube(folder.path("a.ktx2")), mirrored = read_cube(folder.path("m.ktx2")),
                   turned = read_cube(folder.path("r.ktx2"));
    // The mean of the axis' own cosine over a face's texels, by quadrature.
    double cosine = 0.0;
    for (int i = 0; i < 256; ++i)
        for (int j = 0; j < 256; ++j)
            cosine += 1.0 / std::sqrt(1.0 + std::pow((2 * i + 1) / 256.0 - 1, 2) +
                                      std::pow((2 * j + 1) / 256.0 - 1, 2));
    const double half = 0.5 * cosine / 65536.0;
    const auto faces = [&](const CubeFile& file, std::size_t face) { return mean(file.levels[0][face]); };
    expect_near(faces(cube, 0), {1 + half, 1, 1}, 4e-3);
    expect_near(faces(cube, 1), {1 - half, 1, 1}, 4e-3);
    expect_near(faces(cube, 2), {1, 1 + half, 1}, 4e-3);
    expect_near(faces(cube, 3), {1, 1 - half, 1}, 4e-3);
    expect_near(faces(cube, 4), {1, 1, 1 + half}, 4e-3);
    expect_near(faces(cube, 5), {1, 1, 1 - half}, 4e-3);
    expect_near(faces(mirrored, 0), faces(cube, 1), 1e-6);
    expect_near(faces(mirrored, 4), faces(cube, 4), 1e-6);
    EXPECT_EQ(mirrored.metadata.at("lambent.mirrored"), std::string("x") + '\0');
    EXPECT_EQ(mirrored.metadata.at("lambent.sh"), cube.metadata.at("lambent.sh"));
    // Turned counter-clockwise seen from above: what was at +X is at -Z.
    expect_near(faces(turned, 5), {1 + half, 1, 1}, 4e-3);
    expect_near(faces(turned, 0), {1, 1, 1 + half}, 4e-3);
}

TEST(Bake, TheRotationIsRendersRotation)
{
    const Folder folder;
    const auto corner = [&](const char* degrees) {
        const std::string path = folder.path(std::string("r") + degrees + ".exr");
        const Outcome outcome = lambent({"render", "sphere", "--env", write_gradient(folder), "--size", "8x8",
                                         "--camera", "0,0", "--fov", "1", "--background", "env",
                                         "--env-rotation", degrees, "--camera", "0,0,100", "-o", path});
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        return image::read_radiance(path).values;
    };
    // The camera of azimuth 0 looks along -Z, past the sphere in the corner.
    const std::vector<float> picture = corner("90");
    EXPECT_NEAR(picture[0], 1.5, 0.02);
    EXPECT_NEAR(picture[2], 1.0, 0.02);
}

TEST(Bake, EveryFormatOfOneFileHoldsTheSameLight)
{
    const Folder folder;
    baked("studio", folder.path("float.ktx2"), {"--size", "16", "--texels", "float"});
    const CubeFile wanted = read_cube(folder.path("float.ktx2"));
    std::vector<std::pair<std::string, std::vector<std::string>>> others = {
        {"half.ktx2", {"--size", "16"}},
        {"HALF.DDS", {"--size", "16"}},
        {"float.dds", {"--size", "16", "--texels", "float", "--format", "dds"}},
        {"rgb9e5.dds", {"--size", "16", "--texels", "rgb9e5"}},
        {"rgb9e5.ktx2", {"--size", "16", "--texels", "rgb9e5"}}};
    if (image::can_write_zstd())
        others.push_back({"zstd.ktx2", {"--size", "16", "--zstd"}});
    for (const auto& [name, options] : others) {
        baked("studio", folder.path(name), options);
        const CubeFile cube = read_cube(folder.path(name));
        EXPECT_EQ(cube.scheme, name == "zstd.ktx2" ? 2u : 0u);
        ASSERT_EQ(cube.levels.size(), wanted.levels.size()) << name;
        for (std::size_t level = 0; level < wanted.levels.size(); ++level)
            for (std::size_t face = 0; face < 6; ++face)
                for (std::size_t i = 0; i < wanted.levels[level][face].size(); ++i) {
                    const test::Texel &a = cube.levels[level][face][i], &b = wanted.levels[level][face][i];
                    const double most = std::max({b[0], b[1], b[2]});
                    for (std::size_t c = 0; c < 4; ++c)
                        ASSERT_NEAR(a[c], b[c], most / 256.0 + 1e-6) << name << ' ' << level << ' ' << face;
                }
    }
}

TEST(Bake, AFolderGetsEverything)
{
    const Folder folder;
    const std::string out = folder.path("new/of/it");
    baked("furnace", out, {"--size", "8", "--lut", "16"});
    EXPECT_EQ(entries(out), (std::vector<std::string>{"bake.json", "irradiance.ktx2", "sh.txt",
                                                      "specular.ktx2", "split_sum.exr"}));
    const CubeFile irradiance = read_cube(out + "/irradiance.ktx2");
    EXPECT_EQ(irradiance.size, 32u);
    ASSERT_EQ(irradiance.levels.size(), 1u);
    expect_near(mean(irradiance.levels[0][3]), {pi, pi, pi}, 2e-3);
    EXPECT_TRUE(irradiance.metadata.contains("lambent.sh"));
    EXPECT_FALSE(irradiance.metadata.contains("lambent.roughness"));
    const image::RadianceImage table = image::read_radiance(out + "/split_sum.exr");
    EXPECT_EQ(table.width, 16);
    EXPECT_EQ(table.height, 16);
    // Smooth and seen head on: all of F0 and nothing of 1.
    EXPECT_NEAR(table.pixel(15, 0)[0], 1.0, 0.01);
    EXPECT_NEAR(table.pixel(15, 0)[1], 0.0, 0.01);
    const nlohmann::json json = json_in(out + "/bake.json");
    EXPECT_EQ(json["environment"], "furnace");
    EXPECT_EQ(json["specular"]["file"], "specular.ktx2");
    EXPECT_EQ(json["specular"]["error_aimed_at"], 0.01);
    ASSERT_EQ(json["specular"]["levels"].size(), 4u);
    EXPECT_EQ(json["specular"]["levels"][3]["roughness"], 1.0);
    EXPECT_EQ(json["irradiance"]["coefficients"].size(), 27u);
    EXPECT_EQ(json["irradiance"]["files"], nlohmann::json{"irradiance.ktx2"});
    EXPECT_EQ(json["split_sum"]["file"], "split_sum.exr");
    const std::vector<std::uint8_t> sh = read_file(out + "/sh.txt");
    EXPECT_EQ(std::count(sh.begin(), sh.end(), '\n'), 9);
    EXPECT_EQ(numbers_in({sh.begin(), sh.end()}),
              json["irradiance"]["coefficients"].get<std::vector<double>>());
}

TEST(Bake, AFolderMayBeThere)
{
    const Folder folder;
    write_bytes(folder.path("mine.txt"), "keep");
    write_bytes(folder.path("specular.dds"), "old");
    baked("furnace", folder.path(""), {"--size", "2", "--lut", "2", "--irradiance", "sh", "--format", "dds"});
    EXPECT_EQ(entries(folder.path("")),
              (std::vector<std::string>{"bake.json", "mine.txt", "sh.txt", "specular.dds", "split_sum.exr"}));
    EXPECT_EQ(read_cube(folder.path("specular.dds")).size, 2u);
    EXPECT_FALSE(json_in(folder.path("bake.json"))["irradiance"].contains("files"));
}

struct Pictures {
    const char *format, *layout;
    std::vector<const char*> names; // of level 1
    int width, height;              // of level 1
};

TEST(Bake, PicturesOfEveryLayout)
{
    const std::vector<const char*> six = {"_px", "_nx", "_py", "_ny", "_pz", "_nz"};
    for (const Pictures& p : std::vector<Pictures>{{"exr", "faces", six, 4, 4},
                                                   {"hdr", "faces", six, 4, 4},
                                                   {"exr", "cross", {""}, 16, 12},
                                                   {"hdr", "equirect", {""}, 16, 8}}) {
        const Folder folder;
        baked("furnace", folder.path("o"),
              {"--size", "8", "--format", p.format, "--layout", p.layout, "--lut", "4"});
        const std::string end = std::string(".") + p.format;
        for (const char* name : p.names) {
            const std::string path = folder.path("o/specular_1") + name + end;
            const image::RadianceImage image = image::read_radiance(path);
            EXPECT_EQ(image.width, p.width) << path;
            EXPECT_EQ(image.height, p.height) << path;
            EXPECT_TRUE(fs::exists(folder.path("o/irradiance") + name + end));
        }
        EXPECT_EQ(image::read_radiance(folder.path("o/split_sum") + end).width, 4);
        EXPECT_EQ(entries(folder.path("o")).size(), 5 * p.names.size() + 3);
        const nlohmann::json json = json_in(folder.path("o/bake.json"));
        EXPECT_EQ(json["specular"]["levels"][1]["files"][0], "specular_1" + (p.names[0] + end));
    }
}

TEST(Bake, AnUnrolledLevelIsThePanorama)
{
    const Folder folder;
    const std::string gradient = write_gradient(folder);
    baked(gradient, folder.path("o"),
          {"--size", "32", "--format", "exr", "--layout", "equirect", "--lut", "2"});
    const image::RadianceImage wanted = image::read_radiance(gradient),
                               found = image::read_radiance(folder.path("o/specular_0.exr"));
    ASSERT_EQ(found.width, wanted.width);
    ASSERT_EQ(found.height, wanted.height);
    for (std::size_t i = 0; i < wanted.values.size(); ++i)
        ASSERT_NEAR(found.values[i], wanted.values[i], 0.01) << i;
}

TEST(Bake, StatisticsInsteadOfLines)
{
    const Folder folder;
    const Outcome outcome = baked("studio", folder.path("o"), {"--size", "16", "--stats", "json"});
    const nlohmann::json stats = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(stats["command"], "bake");
    EXPECT_EQ(stats["environment"], "studio");
    EXPECT_EQ(stats["output"], folder.path("o"));
    EXPECT_EQ(stats["size"], 16);
    EXPECT_EQ(stats["files"].size(), 5u);
    EXPECT_EQ(stats["irradiance"]["size"], 32);
    ASSERT_EQ(stats["levels"].size(), 5u);
    double most = 0.0;
    for (const nlohmann::json& level : stats["levels"])
        most = std::max(most, level["error"].get<double>());
    EXPECT_GT(most, 0.0);
    EXPECT_LE(most, 0.01);
    EXPECT_EQ(stats["error"], most);
    EXPECT_GT(stats["times_ms"]["bake"], 0.0);
}

TEST(Bake, QuietVerboseAndWarnings)
{
    const Folder folder;
    EXPECT_EQ(baked("furnace", folder.path("a.dds"), {"--size", "2", "--quiet"}).output, "");
    const Outcome verbose = bake("furnace", folder.path("a.dds"), {"--size", "2", "--verbose"});
    EXPECT_EQ(verbose.error, "lambent: wrote " + folder.path("a.dds") + "\n");
    // One file has no place for a table; the contract's options are taken all the same.
    const Outcome more =
        bake("furnace", folder.path("a.dds"), {"--size", "2", "--lut", "8", "--irradiance", "4"});
    EXPECT_EQ(more.code, 0);
    EXPECT_EQ(std::count(more.error.begin(), more.error.end(), '\n'), 2) << more.error;
    EXPECT_EQ(more.error.rfind("lambent: warning: --irradiance", 0), 0u) << more.error;
    EXPECT_EQ(baked("furnace", folder.path("a.dds"), {"--size", "2", "--irradiance", "sh"}).error, "");
}

TEST(Bake, RoughnessAsCmgenHasIt)
{
    const Folder folder;
    baked("furnace", folder.path("a.ktx2"), {"--size", "16", "--roughness", "cmgen"});
    const auto roughness = numbers_in(read_cube(folder.path("a.ktx2")).metadata.at("lambent.roughness"));
    ASSERT_EQ(roughness.size(), 5u);
    for (std::size_t level = 0; level < 5; ++level)
        EXPECT_NEAR(roughness[level], 1.0 - std::sqrt(1.0 - static_cast<double>(level) / 4.0), 1e-6);
}

TEST(Bake, SamplesAreAnError)
{
    const Folder folder;
    for (const auto& [samples, error] : {std::pair("1024", 0.01), {"1", 0.2}, {"1000000000", 0.0005}}) {
        baked("furnace", folder.path("o"),
              {"--size", "2", "--lut", "2", "--irradiance", "sh", "--samples", samples});
        EXPECT_NEAR(json_in(folder.path("o/bake.json"))["specular"]["error_aimed_at"].get<double>(), error,
                    1e-12);
    }
    baked("furnace", folder.path("a.dds"), {"--size", "2", "--error", "0.2"});
    baked("furnace", folder.path("a.dds"), {"--size", "2", "--error", "0.0005"});
}

TEST(Bake, PhongAndGgxDiffer)
{
    const Folder folder;
    baked("studio", folder.path("ggx.ktx2"));
    baked("studio", folder.path("phong.ktx2"), {"--size", "8", "--specular", "phong"});
    const CubeFile ggx = read_cube(folder.path("ggx.ktx2")), phong = read_cube(folder.path("phong.ktx2"));
    EXPECT_EQ(ggx.levels[0], phong.levels[0]);
    EXPECT_NE(ggx.levels[2], phong.levels[2]);
}

void expect_refused(const Outcome& outcome, int code, const std::string& part)
{
    EXPECT_EQ(outcome.code, code) << part << ": " << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: error: ", 0), 0u) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_NE(outcome.error.find(part), std::string::npos) << outcome.error;
    EXPECT_EQ(outcome.output, "");
}

TEST(Bake, BadUsage)
{
    const Folder folder;
    const std::string out = folder.path("o");
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"--size", "0"},
                                               {"--size", "100"},
                                               {"--size", "8192"},
                                               {"--size", "8x8"},
                                               {"--irradiance", "0"},
                                               {"--irradiance", "4097"},
                                               {"--irradiance", "cube"},
                                               {"--specular", "beckmann"},
                                               {"--error", "0"},
                                               {"--error", "0.21"},
                                               {"--error", "nan"},
                                               {"--samples", "0"},
                                               {"--samples", "1.5"},
                                               {"--samples", "9", "--error", "0.1"},
                                               {"--lut", "1"},
                                               {"--lut", "1025"},
                                               {"--format", "ktx"},
                                               {"--roughness", "squared"},
                                               {"--layout", "cross"},
                                               {"--layout", "sphere", "--format", "exr"},
                                               {"--texels", "bc6h"},
                                               {"--texels", "half", "--format", "hdr"},
                                               {"--zstd", "--format", "dds"},
                                               {"--mirrored", "--format", "exr", "--layout", "equirect"},
                                               {"--env-rotation", "east"}})
        expect_refused(bake("furnace", out, words), 2, words[0]);
    expect_refused(bake("none", out), 2, "none");
    expect_refused(bake("furnace", ""), 2, "--output");
    expect_refused(bake("furnace", folder.path("a.exr")), 2, "--format exr");
    expect_refused(bake("furnace", folder.path("a.ktx")), 2, "a.ktx");
    expect_refused(bake("furnace", folder.path("a.ktx2"), {"--format", "dds"}), 2, "--format");
    expect_refused(lambent({"bake", "furnace"}), 2, "--output");
    expect_refused(lambent({"bake", "-o", out}), 2, "env");
    EXPECT_TRUE(entries(folder.path("")).empty());
}

TEST(Bake, WhatCannotBeWrittenIsSaidBeforeTheWork)
{
    const Folder folder;
    write_bytes(folder.path("file"), "keep");
    const std::vector<std::string> long_work = {"--size", "4096", "--error", "0.0005"};
    expect_refused(bake("kitchen", folder.path("no/a.ktx2"), long_work), 5, "a.ktx2");
    expect_refused(bake("kitchen", folder.path("file"), long_work), 5, "not a folder");
    expect_refused(bake("kitchen", folder.path("file/in/it"), long_work), 5, "not a folder");
    fs::create_directory(folder.path("a.dds"));
    expect_refused(bake("kitchen", folder.path("a.dds"), long_work), 5, "a.dds");
    EXPECT_EQ(entries(folder.path("")), (std::vector<std::string>{"a.dds", "file"}));
}

TEST(Bake, ABadPanoramaLeavesNothing)
{
    const Folder folder;
    write_bytes(folder.path("bad.hdr"), "#?RADIANCE\n\n-Y 2 +X");
    expect_refused(bake(folder.path("bad.hdr"), folder.path("out/of/it")), 3, "bad.hdr");
    expect_refused(bake(folder.path("no.exr"), folder.path("a.ktx2")), 3, "no.exr");
    EXPECT_EQ(entries(folder.path("")), std::vector<std::string>{"bad.hdr"});
}

TEST(Bake, BrokenTexelsAreWarnedOf)
{
    const Folder folder;
    image::RadianceImage light{8, 4, 3, std::vector<float>(96, 1.0f)};
    light.values[40] = std::numeric_limits<float>::quiet_NaN();
    image::write_radiance(light, folder.path("nan.exr"));
    const Outcome outcome = bake(folder.path("nan.exr"), folder.path("a.ktx2"));
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.error.rfind("lambent: warning: " + folder.path("nan.exr"), 0), 0u) << outcome.error;
    const CubeFile cube = read_cube(folder.path("a.ktx2"));
    for (const test::Face& face : cube.levels[0])
        expect_near(mean(face), {1, 1, 1}, 1e-2);
}

TEST(Bake, LightThatAFormatDoesNotHoldIsWarnedOf)
{
    const Folder folder;
    image::RadianceImage light{8, 4, 3, std::vector<float>(96, 1e5f)};
    image::write_radiance(light, folder.path("sun.exr"));
    const Outcome cut = bake(folder.path("sun.exr"), folder.path("a.ktx2"), {"--size", "2"});
    EXPECT_EQ(cut.code, 0);
    EXPECT_EQ(cut.error.rfind("lambent: warning: 30 texels are brighter than 65504", 0), 0u) << cut.error;
    EXPECT_EQ(std::count(cut.error.begin(), cut.error.end(), '\n'), 1) << cut.error;
    EXPECT_EQ(read_cube(folder.path("a.ktx2")).levels[1][0][0][0], 65504.0);
    baked(folder.path("sun.exr"), folder.path("a.ktx2"), {"--size", "2", "--texels", "float"});
    EXPECT_NEAR(read_cube(folder.path("a.ktx2")).levels[1][0][0][0], 1e5, 200.0);
    baked(folder.path("sun.exr"), folder.path("o"), {"--size", "2", "--format", "exr", "--lut", "2"});
}

Outcome run_by(const std::string& program, std::vector<std::string> first,
               const std::vector<std::string>& words)
{
    first.push_back(LAMBENT_PROGRAM);
    first.insert(first.end(), words.begin(), words.end());
    return testing::run_program(program, first);
}

TEST(Bake, StoppedItLeavesNothing)
{
    const Folder folder;
    for (const char* signal : {"INT", "TERM", "KILL"})
        for (const char* name : {"out/of/it", "a.ktx2"}) {
            const Outcome outcome =
                run_by("timeout", {std::string("--signal=") + signal, "--preserve-status", "0.5"},
                       {"bake", "kitchen", "-o", folder.path(name), "--size", "1024", "--error", "0.0005",
                        "--threads", "1"});
            EXPECT_EQ(outcome.code, signal[0] == 'I' ? 130 : signal[0] == 'T' ? 143 : 137) << signal;
            EXPECT_EQ(outcome.output, "");
            EXPECT_EQ(outcome.error, "");
            EXPECT_TRUE(entries(folder.path("")).empty()) << signal << ' ' << name;
        }
}

// As on a full disk: 512 or 1024 bytes, by the shell.
TEST(Bake, WhatCannotBeWrittenInFullIsNotLeftInPart)
{
    const Folder folder;
    const auto limited = [&](const std::string& name) {
        const Outcome outcome = run_by("sh", {"-c", "ulimit -f 1; exec \"$0\" \"$@\""},
                                       {"bake", "furnace", "-o", folder.path(name), "--size", "32"});
        expect_refused(outcome, 5, name);
        EXPECT_EQ(outcome.error.find(".lambent-"), std::string::npos) << outcome.error;
    };
    limited("a.ktx2");
    limited("out/of/it");
    EXPECT_TRUE(entries(folder.path("")).empty());
    // What was there stays.
    fs::create_directory(folder.path("there"));
    write_bytes(folder.path("there/bake.json"), "old");
    write_bytes(folder.path("a.ktx2"), "old");
    limited("there");
    limited("a.ktx2");
    EXPECT_EQ(entries(folder.path("there")), std::vector<std::string>{"bake.json"});
    EXPECT_EQ(read_file(folder.path("there/bake.json")).size(), 3u);
    EXPECT_EQ(read_file(folder.path("a.ktx2")).size(), 3u);
}

TEST(Bake, ThreadsChangeNothing)
{
    const Folder folder;
    for (const char* threads : {"1", "2"})
        baked("studio", folder.path(threads), {"--size", "32", "--threads", threads});
    for (const std::string& name : entries(folder.path("1")))
        EXPECT_EQ(read_file(folder.path("1/" + name)), read_file(folder.path("2/" + name))) << name;
}

} // namespace
} // namespace lambent
