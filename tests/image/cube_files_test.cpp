// KTX 2 and DDS files of cube maps, read back by readers that share nothing with the writers.
#include "image/cube/cube_files.h"

#include "base/error.h"
#include "base/file.h"
#include "tests/image/cube_reader.h"
#include "tests/image/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace lambent::image {
namespace {

using namespace lambent::test;

constexpr TexelFormat formats[] = {TexelFormat::half4, TexelFormat::float4, TexelFormat::rgb9e5};

CubeMap some_light(int size, int levels)
{
    CubeMap map = make_cube_map(size, levels);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> exponent(-12.0f, 14.0f);
    for (float& value : map.values)
        value = random() % 16 == 0 ? 0.0f : std::exp2(exponent(random));
    return map;
}

// How far a texel may be off: half a step of what stores it.
double tolerance(TexelFormat format, double value, double largest)
{
    switch (format) {
    case TexelFormat::half4:
        return std::max(std::fabs(value) * 0x1p-11, 0x1p-25);
    case TexelFormat::float4:
        return 0.0;
    case TexelFormat::rgb9e5:
        break;
    }
    return std::max(largest * 0x1p-9, 0x1p-25);
}

void expect_texels(const CubeFile& file, const CubeMap& map, TexelFormat format)
{
    ASSERT_EQ(file.size, static_cast<unsigned>(map.size));
    ASSERT_EQ(file.levels.size(), static_cast<std::size_t>(map.levels));
    for (int level = 0; level < map.levels; ++level)
        for (int face = 0; face < 6; ++face) {
            const Face& texels = file.levels[static_cast<std::size_t>(level)][static_cast<std::size_t>(face)];
            const int size = map.face_size(level);
            ASSERT_EQ(texels.size(), static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
            for (std::size_t i = 0; i < texels.size(); ++i) {
                const int x = static_cast<int>(i) % size, y = static_cast<int>(i) / size;
                const float* const light = map.pixel(level, face, x, y);
                const double largest = std::max({light[0], light[1], light[2]});
                for (std::size_t c = 0; c < 3; ++c)
                    ASSERT_NEAR(texels[i][c], light[c], tolerance(format, light[c], largest))
                        << level << " " << face << " " << x << " " << y;
                ASSERT_EQ(texels[i][3], 1.0);
            }
        }
}

void expect_usage(const std::string& reason, auto&& work)
{
    try {
        work();
        FAIL() << "not refused; wanted: " << reason;
    } catch (const Error& error) {
        EXPECT_EQ(static_cast<int>(error.failure()), static_cast<int>(Failure::usage));
        EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
}

Ktx2Options in(TexelFormat format, bool zstd = false)
{
    return {format, zstd, {}};
}

struct Shape {
    int size, levels;
};
constexpr Shape shapes[] = {{1, 1}, {2, 2}, {5, 1}, {5, 3}, {12, 4}, {16, 3}, {64, 7}};

TEST(CubeFiles, ktx2_gives_every_texel_back)
{
    for (const Shape& shape : shapes)
        for (const TexelFormat format : formats) {
            const CubeMap map = some_light(shape.size, shape.levels);
            expect_texels(read_ktx2(encode_ktx2(map, in(format))), map, format);
        }
}

TEST(CubeFiles, dds_gives_every_texel_back)
{
    for (const Shape& shape : shapes)
        for (const TexelFormat format : formats) {
            const CubeMap map = some_light(shape.size, shape.levels);
            expect_texels(read_dds(encode_dds(map, format)), map, format);
        }
}

TEST(CubeFiles, zstd_gives_every_texel_back)
{
    if (!can_write_zstd()) {
        expect_usage("libzstd", [] { encode_ktx2(some_light(2, 1), in(TexelFormat::half4, true)); });
        return;
    }
    for (const Shape& shape : shapes)
        for (const TexelFormat format : formats) {
            const CubeMap map = some_light(shape.size, shape.levels);
            const CubeFile file = read_ktx2(encode_ktx2(map, in(format, true)));
            EXPECT_EQ(file.scheme, 2u);
            expect_texels(file, map, format);
        }
    const CubeMap black = make_cube_map(64, 7);
    EXPECT_LT(encode_ktx2(black, in(TexelFormat::half4, true)).size(), 1000u);
}

TEST(CubeFiles, ktx2_names_the_format)
{
    const CubeMap map = some_light(4, 3);
    const CubeFile half = read_ktx2(encode_ktx2(map));
    EXPECT_EQ(half.format, 97u);
    EXPECT_EQ(half.type_size, 2u);
    EXPECT_EQ(half.plane_bytes, 8u);
    EXPECT_EQ(half.scheme, 0u);
    const CubeFile full = read_ktx2(encode_ktx2(map, in(TexelFormat::float4)));
    EXPECT_EQ(full.format, 109u);
    EXPECT_EQ(full.type_size, 4u);
    EXPECT_EQ(full.plane_bytes, 16u);
    const CubeFile shared = read_ktx2(encode_ktx2(map, in(TexelFormat::rgb9e5)));
    EXPECT_EQ(shared.format, 123u);
    EXPECT_EQ(shared.type_size, 4u);
    EXPECT_EQ(shared.plane_bytes, 4u);
    for (const CubeFile* file : {&half, &full, &shared}) {
        EXPECT_EQ(file->model, 1u);     // RGBSDA
        EXPECT_EQ(file->primaries, 1u); // BT.709
        EXPECT_EQ(file->transfer, 1u);  // linear
        EXPECT_EQ(file->flags, 0u);     // alpha not multiplied in
    }
}

TEST(CubeFiles, ktx2_describes_floats)
{
    for (const unsigned bits : {16u, 32u}) {
        const TexelFormat format = bits == 16 ? TexelFormat::half4 : TexelFormat::float4;
        const CubeFile file = read_ktx2(encode_ktx2(some_light(2, 1), in(format)));
        ASSERT_EQ(file.samples.size(), 4u);
        for (unsigned c = 0; c < 4; ++c) {
            const DescribedSample& sample = file.samples[c];
            EXPECT_EQ(sample.bit_offset, c * bits);
            EXPECT_EQ(sample.bit_length, bits);
            EXPECT_EQ(sample.channel, c < 3 ? c : 15u); // red, green, blue, alpha
            EXPECT_EQ(sample.qualifiers, 0xc0u);        // float, signed
            EXPECT_EQ(sample.position, (std::array<unsigned, 4>{}));
            EXPECT_EQ(sample.lower, 0xbf800000u); // -1
            EXPECT_EQ(sample.upper, 0x3f800000u); // 1
        }
    }
}

TEST(CubeFiles, ktx2_describes_the_shared_exponent)
{
    const CubeFile file = read_ktx2(encode_ktx2(some_light(2, 1), in(TexelFormat::rgb9e5)));
    ASSERT_EQ(file.samples.size(), 6u);
    for (unsigned c = 0; c < 3; ++c) {
        const DescribedSample &mantissa = file.samples[2 * c], &exponent = file.samples[2 * c + 1];
        EXPECT_EQ(mantissa.bit_offset, 9 * c);
        EXPECT_EQ(mantissa.bit_length, 9u);
        EXPECT_EQ(mantissa.channel, c);
        EXPECT_EQ(mantissa.qualifiers, 0u);
        EXPECT_EQ(mantissa.lower, 0u);
        EXPECT_EQ(mantissa.upper, 8448u);
        EXPECT_EQ(exponent.bit_offset, 27u);
        EXPECT_EQ(exponent.bit_length, 5u);
        EXPECT_EQ(exponent.channel, c);
        EXPECT_EQ(exponent.qualifiers, 0x20u); // exponent
        EXPECT_EQ(exponent.lower, 15u);        // its bias
        EXPECT_EQ(exponent.upper, 31u);
    }
}

TEST(CubeFiles, dds_names_the_format)
{
    const CubeMap map = some_light(4, 3);
    EXPECT_EQ(read_dds(encode_dds(map)).format, 10u);
    EXPECT_EQ(read_dds(encode_dds(map, TexelFormat::float4)).format, 2u);
    EXPECT_EQ(read_dds(encode_dds(map, TexelFormat::rgb9e5)).format, 67u);
}

TEST(CubeFiles, ktx2_has_what_it_is_told)
{
    Ktx2Options options;
    // Lengths that need every amount of padding; sorted by code point, capitals come before small letters.
    options.metadata = {{"lambent.a", "1"},
                        {"Z", ""},
                        {"lambent.ab", "22"},
                        {"lambent.é", "ü 333"},
                        {"KTXwriter", "lambent 0.1.0"}};
    const CubeFile file = read_ktx2(encode_ktx2(some_light(2, 2), options));
    const auto zero = [](const std::string& value) { return value + '\0'; };
    const std::map<std::string, std::string> wanted = {
        {"KTXorientation", zero("rd")}, {"KTXwriter", zero("lambent 0.1.0")}, {"Z", zero("")},
        {"lambent.a", zero("1")},       {"lambent.ab", zero("22")},           {"lambent.é", zero("ü 333")}};
    EXPECT_EQ(file.metadata, wanted);
    EXPECT_EQ(read_ktx2(encode_ktx2(some_light(2, 2))).metadata.at("KTXwriter"), zero("lambent"));
}

TEST(CubeFiles, ktx2_refuses_metadata_that_is_not_its_own)
{
    const CubeMap map = some_light(2, 1);
    const auto with = [](const std::string& key, const std::string& value) {
        return Ktx2Options{TexelFormat::half4, false, {{key, value}}};
    };
    encode_ktx2(map, with("KTXorientation", "rd"));
    expect_usage("'ru'", [&] { encode_ktx2(map, with("KTXorientation", "ru")); });
    for (const char* key : {"", "KTXglFormat", "ktxmine", "KTXcubemapIncomplete"})
        expect_usage(std::string("'") + key + "'", [&] { encode_ktx2(map, with(key, "x")); });
    expect_usage("'a?b'", [&] { encode_ktx2(map, with(std::string("a\0b", 3), "x")); });
}

// Every texel holds its direction; the readers' faces must lie where Direct3D, OpenGL and KTX have them: a
// look along the axis of a face, with that up, has this to the right (in their left-handed world).
TEST(CubeFiles, faces_are_turned_as_the_interfaces_have_them)
{
    constexpr double look[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    constexpr double up[6][3] = {{0, 1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}};
    constexpr int size = 4;
    CubeMap map = make_cube_map(size, 1);
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const float s = (static_cast<float>(x) + 0.5f) / 2 - 1,
                            t = (static_cast<float>(y) + 0.5f) / 2 - 1;
                const float d[6][3] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t},
                                       {s, -1, -t}, {s, -t, 1},  {-s, -t, -1}};
                for (int c = 0; c < 3; ++c)
                    map.pixel(0, face, x, y)[c] = d[face][c];
            }
    const CubeFile files[] = {read_ktx2(encode_ktx2(map)), read_dds(encode_dds(map))};
    for (const CubeFile& file : files)
        for (std::size_t f = 0; f < 6; ++f)
            for (std::size_t i = 0; i < 16; ++i) {
                const std::size_t column = i % 4, row = i / 4;
                const double right = (static_cast<double>(column) + 0.5) / 2 - 1;
                const double above = 1 - (static_cast<double>(row) + 0.5) / 2;
                const double *l = look[f], *u = up[f];
                // up x look points right in a left-handed world.
                const double r[3] = {u[1] * l[2] - u[2] * l[1], u[2] * l[0] - u[0] * l[2],
                                     u[0] * l[1] - u[1] * l[0]};
                for (std::size_t c = 0; c < 3; ++c)
                    ASSERT_EQ(file.levels[0][f][i][c], l[c] + right * r[c] + above * u[c]) << f << " " << i;
            }
}

TEST(CubeFiles, light_beyond_the_format_is_cut)
{
    CubeMap map = make_cube_map(1, 1);
    const float infinity = std::numeric_limits<float>::infinity();
    const float values[] = {1e30f, 65520.0f, infinity, -2.0f, std::nanf(""), -infinity};
    std::copy(std::begin(values), std::end(values), map.values.begin());
    for (const Bytes& bytes : {encode_ktx2(map), encode_dds(map)}) {
        const CubeFile file = bytes[0] == 'D' ? read_dds(bytes) : read_ktx2(bytes);
        EXPECT_EQ(file.levels[0][0][0], (Texel{65504, 65504, 65504, 1}));
        EXPECT_EQ(file.levels[0][1][0], (Texel{-2, 0, -65504, 1}));
    }
    const CubeFile shared = read_dds(encode_dds(map, TexelFormat::rgb9e5));
    EXPECT_EQ(shared.levels[0][0][0], (Texel{65408, 65408, 65408, 1}));
    EXPECT_EQ(shared.levels[0][1][0], (Texel{0, 0, 0, 1}));
    const CubeFile full = read_ktx2(encode_ktx2(map, in(TexelFormat::float4)));
    EXPECT_EQ(full.levels[0][0][0], (Texel{1e30f, 65520, infinity, 1}));
    EXPECT_TRUE(std::isnan(full.levels[0][1][0][1]));
}

TEST(CubeFiles, refuse_what_is_no_cube_map)
{
    CubeMap none;
    expect_usage("not 0", [&] { encode_ktx2(none); });
    expect_usage("not 0", [&] { encode_dds(none); });
    CubeMap negative{-4, 1, {}};
    expect_usage("not -4", [&] { encode_ktx2(negative); });
    CubeMap short_of_values{4, 3, std::vector<float>(10)};
    expect_usage("not 10", [&] { encode_ktx2(short_of_values); });
    expect_usage("not 10", [&] { encode_dds(short_of_values); });
    CubeMap too_deep = make_cube_map(4, 3);
    too_deep.levels = 4;
    expect_usage("1 to 3 levels", [&] { encode_dds(too_deep); });
}

TEST(CubeFiles, are_written_whole_or_not_at_all)
{
    const TemporaryFolder folder;
    const CubeMap map = some_light(4, 2);
    write_ktx2(map, {}, folder / "a.ktx2");
    write_dds(map, TexelFormat::half4, folder / "a.dds");
    EXPECT_EQ(read_file(folder / "a.ktx2"), encode_ktx2(map));
    EXPECT_EQ(read_file(folder / "a.dds"), encode_dds(map));
    EXPECT_THROW(write_ktx2(map, {}, folder / "nowhere/a.ktx2"), Error);
    EXPECT_THROW(write_dds(map, TexelFormat::half4, folder / "nowhere/a.dds"), Error);
    EXPECT_THROW(write_dds({}, TexelFormat::half4, folder / "b.dds"), Error);
    EXPECT_FALSE(std::filesystem::exists(folder / "b.dds"));
}

} // namespace
} // namespace lambent::image
