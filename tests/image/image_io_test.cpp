// Files on disk: the format by content or by name, and writing whole files or nothing.
#include "image/files/image_io.h"
#include "tests/image/bytes.h"
#include "tests/image/temporary_folder.h"

#include <gtest/gtest.h>

#include <unistd.h>

namespace lambent::image {
namespace {

using namespace lambent::test;

RadianceImage some_light()
{
    RadianceImage image{16, 4, 3, {}};
    for (int i = 0; i < 16 * 4 * 3; ++i)
        image.values.push_back(static_cast<float>(128 + i % 100));
    return image;
}

CodeImage some_codes(int bits)
{
    return {4, 2, 3, bits, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * 2 * 3 * bits / 8), 77)};
}

std::size_t files_in(const std::filesystem::path& folder)
{
    const std::filesystem::directory_iterator files(folder);
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

template <class Work>
void expect_failure(Failure failure, const std::string& reason, Work&& work)
{
    try {
        work();
        FAIL() << "not refused; wanted: " << reason;
    } catch (const Error& error) {
        EXPECT_EQ(static_cast<int>(error.failure()), static_cast<int>(failure)) << error.what();
        EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
}

TEST(ImageIo, tells_kinds_by_extension_in_any_case)
{
    EXPECT_EQ(file_kind("a/b.png"), FileKind::png);
    EXPECT_EQ(file_kind("B.PnG"), FileKind::png);
    EXPECT_EQ(file_kind("b.jpg"), FileKind::jpeg);
    EXPECT_EQ(file_kind("b.JPEG"), FileKind::jpeg);
    EXPECT_EQ(file_kind("b.Exr"), FileKind::exr);
    EXPECT_EQ(file_kind("x.png.HDR"), FileKind::hdr);
    for (const char* other : {"b", "png", ".png", "b.png/", "b.tiff", "b.hdr2", ""})
        EXPECT_EQ(file_kind(other), FileKind::unknown) << other;
}

TEST(ImageIo, light_comes_back_from_both_formats_whatever_the_name)
{
    const TemporaryFolder folder;
    for (const char* name : {"light.hdr", "light.EXR"}) {
        write_radiance(some_light(), folder / name);
        std::filesystem::rename(folder / name, folder / "moved.png");
        const RadianceImage back = read_radiance(folder / "moved.png");
        EXPECT_EQ(back.width, 16);
        EXPECT_EQ(back.height, 4);
        EXPECT_EQ(back.channels, 3);
        EXPECT_EQ(back.values, some_light().values) << name;
        EXPECT_EQ(inspect(folder / "moved.png").width, 16);
    }
}

// More rows than are read at a time.
TEST(ImageIo, a_tall_picture_comes_back)
{
    RadianceImage image{20, 60000, 3, {}};
    for (int i = 0; i < 20 * 60000 * 3; ++i)
        image.values.push_back(static_cast<float>(128 + i % 101));
    const TemporaryFolder folder;
    write_radiance(image, folder / "tall.hdr");
    EXPECT_EQ(read_radiance(folder / "tall.hdr").values, image.values);
}

TEST(ImageIo, codes_come_back)
{
    const TemporaryFolder folder;
    write_codes(some_codes(8), folder / "a.png");
    write_codes(some_codes(16), folder / "b.png");
    write_codes(some_codes(8), folder / "c.jpg");
    EXPECT_EQ(read_codes(folder / "a.png").bytes[5], 77);
    EXPECT_EQ(read_codes(folder / "b.png").bits, 16);
    EXPECT_NEAR(read_codes(folder / "c.jpg").bytes[5], 77, 2);
    EXPECT_EQ(inspect(folder / "b.png").format, "PNG");
    EXPECT_EQ(inspect(folder / "c.jpg").format, "JPEG");
}

TEST(ImageIo, says_what_a_wrong_file_is)
{
    const TemporaryFolder folder;
    write_codes(some_codes(8), folder / "a.png");
    write_radiance(some_light(), folder / "a.hdr");
    const auto text = folder.write("text.exr", bytes_of("just some text"));
    const auto empty = folder.write("empty.hdr", {});
    const auto bad = Failure::bad_input;
    expect_failure(bad, "a.png: is a PNG", [&] { read_radiance(folder / "a.png"); });
    expect_failure(bad, "a.hdr: is a Radiance HDR", [&] { read_codes(folder / "a.hdr"); });
    expect_failure(bad, "text.exr: ", [&] { read_radiance(text); });
    expect_failure(bad, "text.exr: ", [&] { read_codes(text); });
    expect_failure(bad, "text.exr: ", [&] { inspect(text); });
    expect_failure(bad, "empty.hdr: is empty", [&] { read_radiance(empty); });
    expect_failure(bad, "empty.hdr: is empty", [&] { read_codes(empty); });
    expect_failure(bad, "texture 3: ", [&] { decode_codes({}, "texture 3"); });
    expect_failure(bad, "missing.hdr: ", [&] { read_radiance(folder / "missing.hdr"); });
    expect_failure(bad, "folder", [&] { read_radiance(folder.path()); });
}

TEST(ImageIo, refuses_what_a_format_cannot_hold)
{
    const TemporaryFolder folder;
    const auto usage = Failure::usage;
    expect_failure(usage, "light.png", [&] { write_radiance(some_light(), folder / "light.png"); });
    expect_failure(usage, "light", [&] { write_radiance(some_light(), folder / "light"); });
    expect_failure(usage, "codes.hdr", [&] { write_codes(some_codes(8), folder / "codes.hdr"); });
    expect_failure(usage, "16-bit", [&] { write_codes(some_codes(16), folder / "codes.jpg"); });
    RadianceImage too_few = some_light();
    too_few.values.pop_back();
    expect_failure(usage, "191 values", [&] { write_radiance(too_few, folder / "few.hdr"); });
    expect_failure(usage, "0x0", [&] { write_radiance({}, folder / "none.hdr"); });
    EXPECT_EQ(files_in(folder.path()), 0u);
}

TEST(ImageIo, leaves_nothing_where_it_cannot_write)
{
    const TemporaryFolder folder;
    const auto cannot = Failure::cannot_write;
    expect_failure(cannot, "nowhere", [&] { write_radiance(some_light(), folder / "nowhere/a.hdr"); });
    expect_failure(cannot, "nowhere", [&] { write_codes(some_codes(8), folder / "nowhere/a.png"); });
    std::filesystem::create_directory(folder / "is.png");
    expect_failure(cannot, "is.png", [&] { write_codes(some_codes(8), folder / "is.png"); });
    EXPECT_EQ(files_in(folder.path()), 1u);
    if (::geteuid() == 0)
        return; // may write everywhere
    std::filesystem::create_directory(folder / "closed");
    std::filesystem::permissions(folder / "closed",
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    expect_failure(cannot, "closed", [&] { write_radiance(some_light(), folder / "closed/a.exr"); });
    expect_failure(cannot, "closed", [&] { write_codes(some_codes(8), folder / "closed/a.jpg"); });
    EXPECT_EQ(files_in(folder / "closed"), 0u);
}

TEST(ImageIo, replaces_a_file_whole)
{
    const TemporaryFolder folder;
    folder.write("a.hdr", bytes_of(std::string(100000, 'x')));
    write_radiance(some_light(), folder / "a.hdr");
    EXPECT_EQ(read_radiance(folder / "a.hdr").values, some_light().values);
    EXPECT_EQ(files_in(folder.path()), 1u);
}

} // namespace
} // namespace lambent::image
