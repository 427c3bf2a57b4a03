// What may be opened, and what not by any name.
#include "apps/viewer/file_list.h"
#include "base/error.h"
#include "base/text.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace lambent::viewer {
namespace {

namespace fs = std::filesystem;

void touch(const fs::path& file)
{
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "x";
}

bool allows_scene(const FileList& files, const std::string& name)
{
    try {
        files.check_scene(name);
        return true;
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::usage);
        return false;
    }
}

TEST(FileList, AllowsWhatItListsAndNothingElse)
{
    const testing::Folder folder;
    const fs::path root = folder.path("");
    for (const char* name :
         {"in/a.glb", "in/sub/b.gltf", "in/secret.txt", "in/c.hdr", "out/d.glb", "in2/e.glb"})
        touch(root / name);
    fs::create_symlink(root / "out/d.glb", root / "in/link.glb");
    fs::create_directory_symlink(root / "out", root / "in/linked");
    fs::create_directory(root / "in/folder.glb");
    const FileList files({root / "in"});
    const std::vector<std::string> scenes = files.scenes();
    const std::string a = (root / "in/a.glb").string(), b = (root / "in/sub/b.gltf").string();
    EXPECT_EQ(
        std::count_if(scenes.begin(), scenes.end(), [](const std::string& name) { return name[0] == '/'; }),
        2);
    for (const std::string& name : scenes)
        EXPECT_TRUE(allows_scene(files, name)) << name;
    EXPECT_TRUE(allows_scene(files, a));
    EXPECT_TRUE(allows_scene(files, b));
    for (const std::string& name :
         {(root / "in/../out/d.glb").string(), (root / "out/d.glb").string(), (root / "in/link.glb").string(),
          (root / "in/linked/d.glb").string(), (root / "in2/e.glb").string(),
          (root / "in/secret.txt").string(), (root / "in/folder.glb").string(), (root / "in/c.hdr").string(),
          (root / "in/none.glb").string(), a + std::string("\0.glb", 5), std::string("/etc/passwd"),
          std::string("--help"), std::string(), std::string(10000, 'x') + ".glb"})
        EXPECT_FALSE(allows_scene(files, name)) << name.substr(0, 100);
    EXPECT_NO_THROW(files.check_environment((root / "in/c.hdr").string()));
    EXPECT_THROW(files.check_environment(a), Error);
}

TEST(FileList, WithoutFoldersOnlyBuiltInNames)
{
    const FileList files({});
    EXPECT_TRUE(allows_scene(files, "grid"));
    EXPECT_FALSE(allows_scene(files, "grid.glb"));
    EXPECT_NO_THROW(files.check_environment("none"));
    EXPECT_THROW(files.check_environment("x.hdr"), Error);
}

TEST(FileList, FoldersAreThoseOfTheFilesNamed)
{
    cli::RenderArguments picture;
    picture.scene = "grid";
    picture.environment = "none";
    EXPECT_TRUE(folders_named(picture).empty());
    picture.scene = "models/duck.glb";
    picture.environment = "sky.hdr";
    EXPECT_EQ(folders_named(picture), (std::vector<fs::path>{"models", ""}));
}

TEST(FileList, IsShortWhateverIsThere)
{
    const testing::Folder folder;
    for (int i = 0; i < 300; ++i)
        touch(folder.path(text("m", i, ".glb")));
    const FileList files({folder.path("")});
    EXPECT_LE(files.scenes().size(), FileList::most_files + 20);
    EXPECT_TRUE(FileList({folder.path("nowhere")}).scenes().size() < 20);
}

} // namespace
} // namespace lambent::viewer
