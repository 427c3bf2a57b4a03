// Scenes shared and loaded again.
#include "apps/viewer/asset_cache.h"
#include "base/error.h"
#include "base/file.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace lambent::viewer {
namespace {

cli::RenderArguments arguments_for(const std::string& scene)
{
    cli::RenderArguments arguments;
    arguments.scene = scene;
    arguments.environment = "none";
    return arguments;
}

void write(const std::string& file, const std::string& content)
{
    write_file(file, {reinterpret_cast<const std::uint8_t*>(content.data()), content.size()});
}

const std::string empty_model = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{}]})";
const std::string model_with_camera =
    R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"camera": 0}], "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}]})";

// Waits until `condition` holds of what is there.
template <class Condition>
bool eventually(AssetCache& assets, const cli::RenderArguments& arguments, Condition&& condition)
{
    for (int i = 0; i < 600 * testing::patience; ++i) {
        if (condition(assets.model(arguments)))
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
}

TEST(AssetCache, GivesTheSameSceneToEverybody)
{
    AssetCache assets({.cache = false});
    const cli::RenderArguments arguments = arguments_for("sphere");
    assets.load(arguments);
    const Found<Model> one = assets.model(arguments), two = assets.model(arguments);
    EXPECT_NE(one.value, nullptr);
    EXPECT_EQ(one.value, two.value);
    cli::RenderArguments other = arguments;
    other.builtin.exponent = 3.0f;
    assets.load(other);
    EXPECT_NE(assets.model(other).value, one.value);
}

TEST(AssetCache, SaysWhatCannotBeLoaded)
{
    AssetCache assets({.cache = false});
    try {
        assets.load(arguments_for("nowhere.glb"));
        ADD_FAILURE() << "loaded";
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        EXPECT_NE(std::string(error.what()).find("nowhere.glb"), std::string::npos);
    }
}

TEST(AssetCache, LoadsFilesAgainWhenTheyChangeAndKeepsTheOldWhenTheyBreak)
{
    const testing::Folder folder;
    const std::string file = folder.path("a.gltf");
    write(file, empty_model);
    AssetCache assets({.cache = false});
    const cli::RenderArguments arguments = arguments_for(file);
    assets.load(arguments);
    const std::shared_ptr<Model> first = assets.model(arguments).value;
    EXPECT_TRUE(first->scene().cameras.empty());
    write(file, model_with_camera);
    EXPECT_TRUE(eventually(assets, arguments, [](const Found<Model>& found) {
        return found.value->scene().cameras.size() == 1;
    }));
    const std::shared_ptr<Model> second = assets.model(arguments).value;
    write(file, "{ broken");
    EXPECT_TRUE(
        eventually(assets, arguments, [](const Found<Model>& found) { return !found.error.empty(); }));
    EXPECT_EQ(assets.model(arguments).value, second);
    write(file, empty_model);
    EXPECT_TRUE(eventually(assets, arguments, [&](const Found<Model>& found) {
        return found.error.empty() && found.value != second;
    }));
}

// Buffers and images beside a glTF are as much of it as its own file; one that breaks it is said, and mended by itself.
TEST(AssetCache, WatchesTheFilesBesideAModel)
{
    const testing::Folder folder;
    const std::string file = folder.path("a.gltf"), buffer = folder.path("a b.bin");
    const std::string corners(36, '\0');
    write(buffer, corners);
    write(file,
          R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "a%20b.bin"}]})");
    AssetCache assets({.cache = false});
    const cli::RenderArguments arguments = arguments_for(file);
    assets.load(arguments);
    const std::shared_ptr<Model> first = assets.model(arguments).value;
    EXPECT_EQ(first->bounds().high.x, 0.0f);
    const auto write_corner = [&](std::size_t bytes) {
        std::string moved = corners;
        const float far = 3.0f;
        std::memcpy(moved.data(), &far, sizeof far);
        write(buffer, moved.substr(0, bytes));
    };
    write_corner(20);
    EXPECT_TRUE(
        eventually(assets, arguments, [](const Found<Model>& found) { return !found.error.empty(); }));
    EXPECT_EQ(assets.model(arguments).value, first);
    write_corner(36);
    EXPECT_TRUE(eventually(assets, arguments, [](const Found<Model>& found) {
        return found.error.empty() && found.value->bounds().high.x == 3.0f;
    }));
}

// A model beside whose folder its buffer lies.
std::string write_model_out_of_folder(const testing::Folder& folder)
{
    std::filesystem::create_directories(folder.path("inside"));
    write(folder.path("corners.bin"), std::string(36, '\0'));
    write(folder.path("inside/a.gltf"),
          R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "../corners.bin"}]})");
    return folder.path("inside/a.gltf");
}

TEST(AssetCache, ReadsNothingOutOfItsReach)
{
    const testing::Folder folder;
    const cli::RenderArguments arguments = arguments_for(write_model_out_of_folder(folder));
    AssetCache narrow({.cache = false});
    EXPECT_THROW(narrow.load(arguments), Error);
    AssetCache inside({.cache = false, .reach = {false, {folder.path("inside")}}});
    EXPECT_THROW(inside.load(arguments), Error);
    AssetCache around({.cache = false, .reach = {false, {folder.path("")}}});
    around.load(arguments);
    AssetCache anywhere({.cache = false, .reach = {true, {}}});
    anywhere.load(arguments);
}

TEST(AssetCache, IsStrictIfAsked)
{
    const testing::Folder folder;
    const std::string file = folder.path("a.gltf");
    write(file, R"({"asset": {"version": "2.0"}, "extensionsUsed": ["VENDOR_x"], "scenes": [{}]})");
    AssetCache mild({.cache = false});
    mild.load(arguments_for(file));
    EXPECT_FALSE(mild.model(arguments_for(file)).value->warnings().empty());
    AssetCache strict({.cache = false, .strict = true});
    try {
        strict.load(arguments_for(file));
        ADD_FAILURE() << "loaded";
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        EXPECT_NE(std::string(error.what()).find("VENDOR_x"), std::string::npos);
    }
}

TEST(AssetCache, KeepsLittleThatNobodyLooksAt)
{
    AssetCache assets({.cache = false});
    std::weak_ptr<Model> first;
    for (int i = 1; i < 30; ++i) {
        cli::RenderArguments arguments = arguments_for("plane");
        arguments.builtin.exponent = static_cast<float>(i);
        assets.load(arguments);
        if (i == 1)
            first = assets.model(arguments).value;
    }
    EXPECT_TRUE(first.expired());
}

} // namespace
} // namespace lambent::viewer
