// The public interface against closed forms, and its files against readers that share nothing with it.
#include "tests/image/cube_reader.h"
#include "tests/image/radiance_writer.h"
#include "tests/image/temporary_folder.h"

#include <lambent/bake.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <thread>

namespace lambent {
namespace {

using test::TemporaryFolder;
using Vec = std::array<double, 3>;
constexpr double pi = std::numbers::pi;

// The direction of a texel as bake.h documents it.
Vec direction_of(const CubeMap& cube, int level, int face, std::array<int, 2> texel)
{
    const double s = (2.0 * texel[0] + 1.0) / cube.face_size(level) - 1.0;
    const double t = (2.0 * texel[1] + 1.0) / cube.face_size(level) - 1.0;
    const Vec faces[6] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}};
    const Vec& d = faces[face];
    const double length = std::hypot(d[0], d[1], d[2]);
    return {d[0] / length, d[1] / length, d[2] / length};
}

// Light that no two axes, signs or channels share, and its irradiance, by which the clamped cosine is pi and 2 pi / 3.
constexpr double slope[3][3] = {{0.5, 0.25, -0.125}, {-0.25, 0.5, 0.25}, {0.125, -0.25, 0.5}};

double sloped(const Vec& d, std::size_t channel, double of_constant, double of_slope)
{
    return of_constant +
           of_slope * (slope[channel][0] * d[0] + slope[channel][1] * d[1] + slope[channel][2] * d[2]);
}

Panorama sloped_panorama(int width)
{
    const int height = width / 2;
    std::vector<float> rgb;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double phi = ((x + 0.5) / width - 0.5) * 2.0 * pi, theta = (y + 0.5) / height * pi;
            const Vec d = {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
            for (std::size_t c = 0; c < 3; ++c)
                rgb.push_back(static_cast<float>(sloped(d, c, 1.0, 1.0)));
        }
    return Panorama::from_pixels(width, height, rgb);
}

test::Bytes contents(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void expect_error(BakeError::Kind kind, const std::string& words, const std::function<void()>& work)
{
    try {
        work();
        ADD_FAILURE() << "no error with '" << words << "'";
    } catch (const BakeError& error) {
        EXPECT_EQ(error.kind(), kind) << error.what();
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(Bake, TheFurnaceIsOneAtEveryRoughness)
{
    const Panorama furnace = Panorama::builtin("furnace", {.width = 64});
    for (const Lobe lobe : {Lobe::ggx, Lobe::phong}) {
        double done = 0.0;
        const SpecularOptions options{.size = 4, .lobe = lobe, .mapping = RoughnessMapping::cmgen};
        const Specular specular = bake_specular(furnace, options, [&](double share) { done = share; });
        EXPECT_EQ(specular.cube.size, 4);
        EXPECT_EQ(specular.cube.values.size(), 3u * 6u * (16 + 4 + 1));
        for (const float value : specular.cube.values)
            EXPECT_NEAR(static_cast<double>(value), 1.0, options.error);
        ASSERT_EQ(specular.levels.size(), 3u);
        EXPECT_NEAR(specular.levels[1].perceptual_roughness, 1.0 - std::sqrt(0.5), 1e-12);
        EXPECT_EQ(specular.levels[2].perceptual_roughness, 1.0);
        EXPECT_GT(done, 0.9);
    }
}

TEST(Bake, IrradianceIsWhatLightOfFirstOrderGives)
{
    const Panorama panorama = sloped_panorama(128);
    const CubeMap cube = bake_irradiance(panorama, 4);
    const Harmonics harmonics = bake_irradiance_harmonics(panorama);
    for (int face = 0; face < 6; ++face)
        for (int i = 0; i < 16; ++i) {
            const Vec n = direction_of(cube, 0, face, {i % 4, i / 4});
            const auto [x, y, z] = n;
            const double basis[9] = {0.282095,     0.488603 * y,     0.488603 * z,
                                     0.488603 * x, 1.092548 * x * y, 1.092548 * y * z,
                                     0.0,          1.092548 * x * z, 0.546274 * (x * x - y * y)};
            for (std::size_t c = 0; c < 3; ++c) {
                const double exact = sloped(n, c, pi, 2.0 * pi / 3.0);
                double sum = harmonics[6][c] * 0.315392 * (3.0 * z * z - 1.0);
                for (std::size_t k = 0; k < 9; ++k)
                    sum += harmonics[k][c] * basis[k];
                EXPECT_NEAR(sum, exact, 5e-3);
                EXPECT_NEAR(cube.values[cube.index(0, face, i % 4, i / 4) + c], exact, 2e-2);
            }
        }
}

TEST(Bake, TheSplitSumTableReflectsAllOfASmoothWhiteMetal)
{
    const SplitSumTable table = bake_split_sum_table(8);
    ASSERT_EQ(table.values.size(), 3u * 64u);
    const float* smooth_head_on = table.values.data() + std::size_t{3} * 7;
    EXPECT_NEAR(smooth_head_on[2], 1.0f, 1e-3f);
    const float* rough_grazing = table.values.data() + std::size_t{3} * 56;
    EXPECT_LT(rough_grazing[2], 0.9f);
    EXPECT_NEAR(rough_grazing[0] + rough_grazing[1], rough_grazing[2], 1e-6f);
}

TEST(Bake, APanoramaInMemoryIsThatInAFile)
{
    const TemporaryFolder folder;
    const test::Pixels pixels = test::mixed_pixels(32 * 16, 5);
    const test::Bytes header = test::radiance_header("-Y 16 +X 32");
    const auto path = folder.write("a.hdr", test::operator+(header, test::flat_scanline(pixels)));
    std::vector<float> rgb;
    for (const test::Pixel& pixel : pixels)
        for (const float value : test::radiance_of(pixel))
            rgb.push_back(value);
    const Panorama file = Panorama::load(path), memory = Panorama::from_pixels(32, 16, rgb);
    ASSERT_EQ(file.width(), 32);
    ASSERT_EQ(file.height(), 16);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x)
            EXPECT_EQ(file.radiance(x, y), memory.radiance(x, y)) << x << "," << y;
    EXPECT_EQ(file.warnings().size(), memory.warnings().size());
}

TEST(Bake, BrokenTexelsAreMendedAndToldOf)
{
    std::vector<float> rgb(3 * 8 * 8, 2.0f);
    rgb[30] = std::numeric_limits<float>::quiet_NaN();
    rgb[60] = -1.0f;
    const Panorama panorama = Panorama::from_pixels(8, 8, rgb);
    EXPECT_EQ(panorama.radiance(2, 1), (std::array<float, 3>{2.0f, 2.0f, 2.0f}));
    EXPECT_EQ(panorama.radiance(4, 2), (std::array<float, 3>{0.0f, 2.0f, 2.0f}));
    EXPECT_EQ(panorama.warnings().size(), 3u); // and it is not twice as wide as high
}

TEST(Bake, FilesHoldTheCube)
{
    const TemporaryFolder folder;
    CubeMap cube{4, 3, std::vector<float>(3 * 6 * (16 + 4 + 1))};
    for (std::size_t i = 0; i < cube.values.size(); ++i)
        cube.values[i] = static_cast<float>(i) / 8.0f;
    write_ktx2(cube, folder / "a.ktx2",
               {.format = TexelFormat::float4, .zstd = can_write_zstd(), .metadata = {{"a", "b"}}});
    write_dds(cube, folder / "a.dds");
    const test::CubeFile ktx2 = test::read_ktx2(contents(folder / "a.ktx2"));
    const test::CubeFile dds = test::read_dds(contents(folder / "a.dds"));
    EXPECT_EQ(ktx2.metadata.at("a"), std::string("b\0", 2));
    for (const test::CubeFile* file : {&ktx2, &dds}) {
        ASSERT_EQ(file->size, 4u);
        ASSERT_EQ(file->levels.size(), 3u);
    }
    for (int level = 0; level < 3; ++level)
        for (int face = 0; face < 6; ++face) {
            const std::size_t l = static_cast<std::size_t>(level), f = static_cast<std::size_t>(face);
            const int n = cube.face_size(level), last = n * n - 1;
            for (std::size_t c = 0; c < 3; ++c) {
                const float value = cube.values[cube.index(level, face, n - 1, n - 1) + c];
                EXPECT_EQ(ktx2.levels[l][f][static_cast<std::size_t>(last)][c], value);
                EXPECT_EQ(dds.levels[l][f][static_cast<std::size_t>(last)][c], value);
            }
        }
}

TEST(Bake, WhatIsOutOfRangeIsABadArgument)
{
    constexpr auto bad = BakeError::Kind::bad_argument;
    const Panorama furnace = Panorama::builtin("furnace", {.width = 64});
    const std::vector<float> rgb(3 * 4 * 2, 1.0f);
    expect_error(bad, "0x2", [&] { Panorama::from_pixels(0, 2, rgb); });
    expect_error(bad, "-4x-2", [&] { Panorama::from_pixels(-4, -2, rgb); });
    expect_error(bad, "65536x65536", [&] { Panorama::from_pixels(65536, 65536, rgb); });
    expect_error(bad, "24 floats", [&] { Panorama::from_pixels(4, 3, rgb); });
    expect_error(bad, "attic", [] { Panorama::builtin("attic"); });
    expect_error(bad, "100", [] { Panorama::builtin("sky", {.width = 100}); });
    expect_error(bad, "64,0", [&] { furnace.radiance(64, 0); });
    expect_error(bad, "48", [&] { bake_specular(furnace, {.size = 48}); });
    expect_error(bad, "0.5", [&] { bake_specular(furnace, {.error = 0.5}); });
    expect_error(bad, "0 texels", [&] { bake_irradiance(furnace, 0); });
    expect_error(bad, "1 texels", [] { bake_split_sum_table(1); });
    const TemporaryFolder folder;
    expect_error(bad, "", [&] { write_ktx2({2, 1, {1.0f}}, folder / "a.ktx2"); });
    expect_error(bad, "", [&] { write_dds({}, folder / "a.dds"); });
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Bake, FilesThatCannotBeReadOrWrittenAreNamed)
{
    const TemporaryFolder folder;
    expect_error(BakeError::Kind::bad_input, "none.hdr", [&] { Panorama::load(folder / "none.hdr"); });
    const auto broken = folder.write("broken.hdr", test::radiance_header("-Y 16 +X 32"));
    expect_error(BakeError::Kind::bad_input, "broken.hdr", [&] { Panorama::load(broken); });
    const CubeMap cube{1, 1, std::vector<float>(18)};
    expect_error(BakeError::Kind::cannot_write, "a.ktx2", [&] { write_ktx2(cube, folder / "no/a.ktx2"); });
    expect_error(BakeError::Kind::cannot_write, "a.dds", [&] { write_dds(cube, folder / "no/a.dds"); });
}

TEST(Bake, WhatProgressThrowsComesOut)
{
    struct Enough {};
    const Panorama furnace = Panorama::builtin("furnace", {.width = 64});
    EXPECT_THROW(bake_specular(furnace, {.size = 4}, [](double) { throw Enough(); }), Enough);
}

TEST(Bake, ThreadsMayShareAPanorama)
{
    const Panorama panorama = sloped_panorama(128);
    CubeMap cubes[2];
    std::thread other([&, copy = panorama] { cubes[0] = bake_irradiance(copy, 8); });
    cubes[1] = bake_irradiance(panorama, 8);
    other.join();
    EXPECT_EQ(cubes[0].values, cubes[1].values);
}

} // namespace
} // namespace lambent
