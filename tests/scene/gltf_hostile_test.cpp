// Damaged files: whatever the bytes, loading returns or throws lambent::Error.
#include "scene/gltf/gltf.h"
#include "tests/scene/gltf_builder.h"
#include "tests/scene/rich_file.h"

#include <gtest/gtest.h>

#include <random>

namespace lambent::scene::test {
namespace {

enum class Outcome { loaded, refused };

// Any other exception passes through and fails the test; a crash fails it anyway. Animations are looked at twice.
Outcome try_load(const Bytes& bytes)
{
    try {
        Warnings unread;
        const GltfFile file({"test.gltf", bytes, std::nullopt}, unread);
        file.scene(std::nullopt, unread);
        for (std::size_t i = 0; i < file.animations().size(); ++i)
            for (const double part : {0.0, 0.6})
                file.pose({static_cast<int>(i), part * file.animations()[i].seconds});
        return Outcome::loaded;
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        const std::string_view line = error.what();
        EXPECT_TRUE(line.starts_with("test.gltf: ")) << line;
        EXPECT_EQ(line.find('\n'), std::string_view::npos) << line;
        return Outcome::refused;
    }
}

TEST(GltfHostile, TheUndamagedFileLoads)
{
    Warnings warnings;
    const Scene scene = load(rich_file(), &warnings);
    EXPECT_EQ(scene.meshes.size(), 4u); // the last for what is flattened
    EXPECT_EQ(scene.animations.size(), 1u);
    EXPECT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.lights.size(), 1u);
    EXPECT_FALSE(scene.meshes[0].tangents.empty());
}

// Changes one to four bytes; half of the time to characters that mean something in JSON.
Bytes damaged(Bytes bytes, std::mt19937& random)
{
    constexpr std::string_view telling = "0123456789-+.eE,:[]{}\"\\ntf ";
    const unsigned count = 1 + random() % 4;
    for (unsigned i = 0; i < count; ++i) {
        const std::size_t at = random() % bytes.size();
        bytes[at] = random() % 2 ? static_cast<std::uint8_t>(telling[random() % telling.size()])
                                 : static_cast<std::uint8_t>(random());
    }
    return bytes;
}

TEST(GltfHostile, DamagedBytesNeverDoWorseThanAnError)
{
    std::mt19937 random(20140613);
    for (const Bytes& whole : {rich_file().glb(), rich_file().gltf()}) {
        int refused = 0;
        for (int i = 0; i < 3000; ++i)
            refused += try_load(damaged(whole, random)) == Outcome::refused ? 1 : 0;
        EXPECT_GT(refused, 300);
        EXPECT_LT(refused, 3000);
    }
}

TEST(GltfHostile, EveryPrefixIsHandled)
{
    for (const Bytes& whole : {rich_file().glb(), rich_file().gltf()})
        for (std::size_t length = 0; length < whole.size(); length += 7)
            EXPECT_EQ(try_load(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length))),
                      Outcome::refused)
                << length;
}

// All numbers, strings and containers of a document.
void collect(json& value, std::vector<json*>& found)
{
    found.push_back(&value);
    if (value.is_structured())
        for (json& inner : value)
            collect(inner, found);
}

TEST(GltfHostile, EveryValueMayBeReplacedByAnything)
{
    const json replacements[] = {
        nullptr,    true,          -1,    0,    1,  3,      255,           65536,
        2147483647, 4294967295u,   1e300, -0.5, "", "VEC4", json::array(), json::object(),
        {0},        {{"index", 0}}};
    const json original = json::parse(rich_file().gltf());
    json document = original;
    std::vector<json*> values;
    collect(document, values);
    int refused = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (const json& replacement : replacements) {
            json copy = original;
            std::vector<json*> places;
            collect(copy, places);
            *places[i] = replacement;
            refused += try_load(to_bytes(copy.dump())) == Outcome::refused ? 1 : 0;
        }
    }
    EXPECT_GT(refused, 0);
}

TEST(GltfHostile, EveryMemberMayBeMissing)
{
    const json original = json::parse(rich_file().gltf());
    json document = original;
    std::vector<json*> values;
    collect(document, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!values[i]->is_object())
            continue;
        for (const auto& [name, inner] : values[i]->items()) {
            json copy = original;
            std::vector<json*> places;
            collect(copy, places);
            places[i]->erase(name);
            try_load(to_bytes(copy.dump()));
        }
    }
}

TEST(GltfHostile, ManyInstancesOfManyPrimitivesAreRefused)
{
    GltfBuilder builder = triangle();
    json& primitives = builder.document["meshes"][0]["primitives"];
    for (int i = 1; i < 3000; ++i)
        primitives.push_back(primitives[0]);
    for (int i = 1; i < 3000; ++i)
        builder.add_node({{"mesh", 0}});
    EXPECT_EQ(refusal(builder), "test.gltf: more than 1000000 instances");
}

std::string nodes_of(std::string_view node, int count)
{
    std::string text = R"({"asset":{"version":"2.0"},"nodes":[)";
    for (int i = 0; i < count; ++i)
        (text += i == 0 ? "" : ",") += node;
    return text + "]}";
}

TEST(GltfHostile, ManySmallObjectsTakeTimeInProportion)
{
    // Quadratic work on these would take minutes.
    EXPECT_EQ(refusal(to_bytes(nodes_of("{}", 300'000))), "");
}

TEST(GltfHostile, TooManyBrokenElementsAreRefused)
{
    // What stands for one is far larger than what is in the file.
    std::string text = R"({"asset":{"version":"2.0"},"accessors":[7)";
    for (int i = 1; i < 10'000; ++i)
        text += ",7";
    EXPECT_EQ(refusal(to_bytes(text + "]}")), "test.gltf: accessor 0: not an object");
    EXPECT_EQ(refusal(to_bytes(text + ",7]}")),
              "test.gltf: accessor 10000: not an object (and more than 10000 elements are broken)");
}

TEST(GltfHostile, MoreStructsThanTheTextCanMeanAreRefused)
{
    EXPECT_EQ(refusal(to_bytes(nodes_of("0", 4'000'000))),
              "test.gltf: JSON: more elements than a file of its size may have");
}

// Large files hold many: matrices of a few hundred thousand nodes, and what exporters write about each of them.
TEST(GltfHostile, MillionsOfNumbersAreNoFault)
{
    std::string zeros = "0";
    for (int i = 0; i < 2'500'000; ++i)
        zeros += ",0";
    EXPECT_EQ(refusal(to_bytes(R"({"asset":{"version":"2.0"},"extras":[)" + zeros +
                               R"(],"meshes":[{"weights":[)" + zeros + "]}]}")),
              "");
}

} // namespace
} // namespace lambent::scene::test
