// Hierarchy, cameras, lights.
#include "tests/scene/gltf_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace lambent::scene::test {
namespace {

void expect_near(glm::vec3 a, glm::vec3 b, float bound = 1e-6f)
{
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], bound) << "component " << i;
}

glm::vec3 apply(const glm::mat4& matrix, glm::vec3 point)
{
    return glm::vec3(matrix * glm::vec4(point, 1.0f));
}

// The triangle's mesh under a tree of nodes.
GltfBuilder with_nodes(const json& nodes, const json& roots)
{
    GltfBuilder builder = triangle();
    builder.document["nodes"] = nodes;
    builder.document["scenes"] = {{{"nodes", roots}}};
    return builder;
}

TEST(GltfNodes, TranslationRotationScaleApplyInThisOrderFromTheRight)
{
    const double half = std::sqrt(0.5); // a quarter turn about +Z takes +X to +Y
    const Scene scene = load(with_nodes(
        {{{"mesh", 0}, {"translation", {10, 0, 0}}, {"rotation", {0, 0, half, half}}, {"scale", {2, 3, 4}}}},
        {0}));
    expect_near(apply(scene.instances.at(0).transform, {1, 0, 0}), {10, 2, 0}, 1e-5f);
    expect_near(apply(scene.instances.at(0).transform, {0, 1, 0}), {7, 0, 0}, 1e-5f);
    expect_near(apply(scene.instances.at(0).transform, {0, 0, 1}), {10, 0, 4}, 1e-5f);
}

TEST(GltfNodes, MatricesAreColumnMajor)
{
    const Scene scene =
        load(with_nodes({{{"mesh", 0}, {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}}}, {0}));
    expect_near(apply(scene.instances.at(0).transform, {1, 0, 0}), {5, 7, 7});
}

TEST(GltfNodes, ParentsApplyAfterChildren)
{
    const Scene scene = load(with_nodes({{{"children", {2}}, {"scale", {2, 2, 2}}},
                                         {{"mesh", 0}, {"translation", {0, 1, 0}}},
                                         {{"children", {1}}, {"translation", {1, 0, 0}}}},
                                        {0}));
    ASSERT_EQ(scene.instances.size(), 1u);
    expect_near(apply(scene.instances[0].transform, {0, 0, 0}), {2, 2, 0});
}

TEST(GltfNodes, OneMeshManyInstances)
{
    const Scene scene =
        load(with_nodes({{{"mesh", 0}}, {{"mesh", 0}, {"scale", {-1, 1, 1}}}, {{"mesh", 0}}}, {0, 1, 2}));
    EXPECT_EQ(scene.meshes.size(), 1u);
    ASSERT_EQ(scene.instances.size(), 3u);
    EXPECT_EQ(scene.instances[1].transform[0][0], -1.0f) << "mirrored transforms are kept";
    EXPECT_EQ(scene.instances[0].material, -1);
    EXPECT_EQ(triangle_count(scene), 3u);
}

TEST(GltfNodes, TheDefaultSceneIsDrawnElseTheFirstElseAllRoots)
{
    GltfBuilder builder = with_nodes(
        {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {1, 0, 0}}}, {{"mesh", 0}, {"translation", {2, 0, 0}}}},
        {1});
    builder.document["scenes"].push_back({{"nodes", {2, 0}}});
    const auto positions = [&] {
        std::vector<float> x;
        for (const Instance& instance : load(builder).instances)
            x.push_back(instance.transform[3].x);
        return x;
    };
    EXPECT_EQ(positions(), std::vector<float>{1});
    builder.document["scene"] = 1;
    EXPECT_EQ(positions(), (std::vector<float>{2, 0}));
    builder.document["scene"] = 2;
    EXPECT_EQ(complaint(builder), "test.gltf: scene 2 does not exist: ignored");
    EXPECT_EQ(positions(), std::vector<float>{1}) << "the first";
    builder.document.erase("scene");
    builder.document.erase("scenes");
    EXPECT_EQ(positions(), (std::vector<float>{0, 1, 2}));
    builder.document["scenes"] = json::array({json::object()});
    EXPECT_TRUE(positions().empty());
}

TEST(GltfNodes, LinksThatMakeNoForestAreLeftOut)
{
    const json shown = {{"mesh", 0}};
    const auto complaint_of = [](const json& nodes, const json& roots, std::size_t instances) {
        const GltfBuilder builder = with_nodes(nodes, roots);
        EXPECT_EQ(load(builder).instances.size(), instances);
        return complaint(builder);
    };
    EXPECT_EQ(complaint_of(json::array({{{"mesh", 0}, {"children", {5}}}}), {0}, 1),
              "test.gltf: node 0: child 5 does not exist: left out");
    EXPECT_EQ(complaint_of({{{"children", {2}}}, {{"children", {2}}}, shown}, {0, 1}, 1),
              "test.gltf: node 2 has two parents, 0 and 1: the first one is kept");
    EXPECT_EQ(complaint_of({{{"children", {1, 1}}}, shown}, {0}, 1),
              "test.gltf: node 1 has two parents, 0 and 0: the first one is kept");
    EXPECT_EQ(complaint_of(json::array({{{"mesh", 0}, {"children", {0}}}}), {0}, 1),
              "test.gltf: node 0 is its own ancestor: cut off from its parent");
    EXPECT_EQ(complaint_of({shown, shown}, {0, 1, 0}, 2),
              "test.gltf: scene 0: node 0 is listed twice: drawn once");
    EXPECT_EQ(complaint_of(json::array({shown}), {0, 3}, 1),
              "test.gltf: scene 0: node 3 does not exist: left out");
    EXPECT_EQ(complaint_of({shown, {{"mesh", 3}}}, {0, 1}, 1),
              "test.gltf: node 1: mesh 3 does not exist: left out");
    EXPECT_EQ(complaint_of({{{"mesh", 0}, {"children", {-1, 1}}}, shown}, {0}, 2),
              "test.gltf: node 0: children is not a whole number from 0 to 2147483647: ignored");
    EXPECT_EQ(complaint_of({shown, 7}, {0, 1}, 1), "test.gltf: node 1: not an object: left out");
}

TEST(GltfNodes, ACycleLosesOneLinkAndIsDrawnFromThere)
{
    // 1 -> 2 -> 3 -> 1, and 4 hangs on 3; each one metre further than its parent.
    const auto step = [](const json& children) {
        return json{{"mesh", 0}, {"translation", {1, 0, 0}}, {"children", children}};
    };
    GltfBuilder builder = with_nodes(
        {json::object(), step({2}), step({3}), step({1, 4}), {{"mesh", 0}, {"translation", {1, 0, 0}}}},
        {0, 1});
    EXPECT_EQ(complaint(builder), "test.gltf: node 1 is its own ancestor: cut off from its parent");
    std::vector<float> x;
    for (const Instance& instance : load(builder).instances)
        x.push_back(instance.transform[3].x);
    EXPECT_EQ(x, (std::vector<float>{1, 2, 3, 4}));
}

TEST(GltfNodes, ARootWithAParentIsDrawnWhereThatPutsIt)
{
    GltfBuilder builder = with_nodes(
        {{{"children", {1}}, {"translation", {5, 0, 0}}}, {{"mesh", 0}, {"translation", {1, 0, 0}}}}, {1});
    EXPECT_EQ(complaint(builder), "test.gltf: scene 0: root node 1 has a parent, node 0: "
                                  "the parent's transform applies");
    EXPECT_EQ(load(builder).instances.at(0).transform[3].x, 6.0f);
    builder.document["scenes"][0]["nodes"] = {0, 1};
    EXPECT_EQ(load(builder).instances.size(), 1u) << "reached twice, drawn once";
}

TEST(GltfNodes, WhereNothingIsLeftTheFaultIsTheError)
{
    EXPECT_EQ(refusal(with_nodes({{{"children", {5}}}}, {0})), "test.gltf: node 0: child 5 does not exist");
    EXPECT_EQ(refusal(with_nodes(json::array({json::object()}), {3})),
              "test.gltf: scene 0: node 3 does not exist");
    EXPECT_EQ(refusal(with_nodes({{{"mesh", 3}}}, {0})), "test.gltf: node 0: mesh 3 does not exist");
    EXPECT_EQ(refusal(with_nodes({{{"children", {-1}}}}, {0})),
              "test.gltf: node 0: children is not a whole number from 0 to 2147483647");
    GltfBuilder builder = triangle();
    builder.document["nodes"] = 3;
    EXPECT_EQ(refusal(builder), "test.gltf: nodes is not an array");
}

TEST(GltfNodes, AChainOfFiftyThousandIsNoTrouble)
{
    json nodes = json::array();
    for (int i = 1; i < 50000; ++i)
        nodes.push_back({{"children", {i}}, {"translation", {1, 0, 0}}});
    nodes.push_back({{"mesh", 0}});
    const Scene scene = load(with_nodes(nodes, {0}));
    EXPECT_EQ(scene.origin.x + static_cast<double>(scene.instances.at(0).transform[3].x), 49999.0);
}

TEST(GltfNodes, TransformsThatAreNoneAreMended)
{
    const GltfBuilder turned =
        with_nodes({{{"mesh", 0}, {"rotation", {0, 0, 0, 0}}, {"scale", {2, 2, 2}}}}, {0});
    EXPECT_EQ(complaint(turned), "test.gltf: node 0: its rotation has no length: ignored");
    expect_near(apply(load(turned).instances.at(0).transform, {1, 0, 0}), {2, 0, 0});
    const GltfBuilder skewed =
        with_nodes({{{"mesh", 0}, {"matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1}}}}, {0});
    EXPECT_EQ(complaint(skewed), "test.gltf: node 0: its matrix is not affine: its last row is ignored");
    expect_near(apply(load(skewed).instances.at(0).transform, {1, 0, 0}), {4, 0, 0});
    Warnings warnings;
    const Scene scene = load(with_nodes({{{"scale", {1e30, 1, 1}}, {"children", {1}}},
                                         {{"mesh", 0}, {"scale", {1e30, 1, 1}}},
                                         {{"mesh", 0}}},
                                        {0, 2}),
                             &warnings);
    EXPECT_EQ(scene.instances.size(), 1u);
    EXPECT_TRUE(
        warned_once(warnings, "test.gltf: node 1: its transform in the world is not finite: left out"));
}

TEST(GltfNodes, ARotationThatIsNotOfUnitLengthIsNormalised)
{
    Warnings warnings;
    const Scene scene = load(with_nodes({{{"mesh", 0}, {"rotation", {0, 0, 3, 3}}}}, {0}), &warnings);
    expect_near(apply(scene.instances.at(0).transform, {1, 0, 0}), {0, 1, 0});
    EXPECT_EQ(warnings, Warnings{"test.gltf: 1 node rotations were not of unit length: normalised"});
}

TEST(GltfNodes, SingularInstancesAreLeftOutWithAWarning)
{
    Warnings warnings;
    const Scene scene = load(
        with_nodes({{{"mesh", 0}, {"scale", {0, 0, 0}}}, {{"mesh", 0}, {"scale", {1, 0, 1}}}, {{"mesh", 0}}},
                   {0, 1, 2}),
        &warnings);
    EXPECT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(warnings, Warnings{"test.gltf: 2 instances flattened by a singular transform: left out"});
    // Small is not singular.
    EXPECT_EQ(load(with_nodes({{{"mesh", 0}, {"scale", {1e-6, 1e-6, 1e-6}}}}, {0})).instances.size(), 1u);
}

GltfBuilder with_camera(const json& camera, const json& node)
{
    GltfBuilder builder = triangle();
    builder.document["cameras"] = json::array({camera});
    json complete = node;
    complete["camera"] = 0;
    builder.add_node(complete);
    return builder;
}

const json lens = {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}};

TEST(GltfCameras, ScaleIsTakenOut)
{
    const double half = std::sqrt(0.5); // a quarter turn about +Y takes -Z to -X
    json camera = lens;
    camera["name"] = "lens";
    const Scene scene = load(with_camera(
        camera, {{"translation", {1, 2, 3}}, {"rotation", {0, half, 0, half}}, {"scale", {-2, 3, 0.5}}}));
    ASSERT_EQ(scene.cameras.size(), 1u);
    const Camera& c = scene.cameras[0];
    EXPECT_EQ(c.name, "lens");
    EXPECT_FLOAT_EQ(c.vertical_fov, 0.8f);
    EXPECT_EQ(c.vertical_size, 0.0f);
    expect_near(apply(c.transform, {0, 0, -1}), {0, 2, 3});
    expect_near(apply(c.transform, {0, 1, 0}), {1, 3, 3});
    expect_near(apply(c.transform, {1, 0, 0}), {1, 2, 2});
}

TEST(GltfCameras, WithoutANameItGetsItsNumber)
{
    const json camera = {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}};
    EXPECT_EQ(load(with_camera(camera, json::object())).cameras.at(0).name, "camera0");
}

TEST(GltfCameras, OrthographicAndNamedByTheNode)
{
    const json camera = {{"type", "orthographic"},
                         {"name", "lens"},
                         {"orthographic", {{"xmag", 3}, {"ymag", 1.5}, {"znear", 0}, {"zfar", 10}}}};
    const Scene scene = load(with_camera(camera, {{"name", "front"}}));
    EXPECT_EQ(scene.cameras.at(0).name, "front");
    EXPECT_EQ(scene.cameras[0].vertical_fov, 0.0f);
    EXPECT_EQ(scene.cameras[0].vertical_size, 3.0f);
}

TEST(GltfCameras, SayHowWideAndBetweenWhichPlanesTheySee)
{
    const auto read = [](const json& camera) {
        Warnings warnings;
        const Scene scene = load(with_camera(camera, json::object()), &warnings);
        EXPECT_TRUE(warnings.empty()) << warnings.front();
        return scene.cameras.at(0);
    };
    const Camera plain = read(lens);
    EXPECT_EQ(plain.aspect, 0.0f);
    EXPECT_EQ(plain.near, 0.1f);
    EXPECT_EQ(plain.far, std::numeric_limits<float>::infinity());
    json full = lens;
    full["perspective"]["aspectRatio"] = 1.5;
    full["perspective"]["zfar"] = 20;
    EXPECT_EQ(read(full).aspect, 1.5f);
    EXPECT_EQ(read(full).far, 20.0f);
    const Camera flat = read({{"type", "orthographic"},
                              {"orthographic", {{"xmag", 3}, {"ymag", 1.5}, {"znear", 0}, {"zfar", 10}}}});
    EXPECT_EQ(flat.aspect, 2.0f);
    EXPECT_EQ(flat.near, 0.0f);
    EXPECT_EQ(flat.far, 10.0f);
}

TEST(GltfCameras, WhatMakesNoSenseIsPassedOverWithAWarning)
{
    const auto read = [](const json& camera, const char* warning) {
        Warnings warnings;
        const Scene scene = load(with_camera(camera, json::object()), &warnings);
        EXPECT_TRUE(warned_once(warnings, warning)) << warning;
        return scene.cameras.at(0);
    };
    json odd = lens;
    odd["perspective"]["aspectRatio"] = -2;
    EXPECT_EQ(read(odd, "camera 0: aspectRatio is not a positive number").aspect, 0.0f);
    odd = lens;
    odd["perspective"]["zfar"] = 0.05;
    EXPECT_EQ(read(odd, "camera 0: znear and zfar are not valid clipping planes").near, 0.0f);
    odd["perspective"] = {{"yfov", 0.8}, {"znear", -1}};
    EXPECT_EQ(read(odd, "camera 0: znear and zfar are not valid clipping planes").near, 0.0f);
    json flat = {{"type", "orthographic"},
                 {"orthographic", {{"xmag", -3}, {"ymag", -1.5}, {"znear", 0}, {"zfar", 10}}}};
    const Camera turned = read(flat, "camera 0: a negative xmag or ymag");
    EXPECT_EQ(turned.aspect, 2.0f);
    EXPECT_EQ(turned.vertical_size, 3.0f);
    flat["orthographic"]["xmag"] = 0;
    flat["orthographic"]["ymag"] = 1;
    EXPECT_EQ(read(flat, "camera 0: xmag is not a valid size").aspect, 0.0f);
}

TEST(GltfCameras, ImpossibleOnesAreLeftOut)
{
    const auto broken = [](const json& camera) {
        const GltfBuilder builder = with_camera(camera, json::object());
        EXPECT_TRUE(load(builder).cameras.empty());
        return complaint(builder);
    };
    json wide = lens;
    wide["perspective"]["yfov"] = 3.2;
    EXPECT_EQ(broken(wide), "test.gltf: camera 0: yfov 3.2 is not between 0 and pi: the camera is left out");
    wide["perspective"]["yfov"] = 0;
    EXPECT_EQ(broken(wide), "test.gltf: camera 0: yfov 0 is not between 0 and pi: the camera is left out");
    EXPECT_EQ(broken({{"type", "orthographic"},
                      {"orthographic", {{"xmag", 1}, {"ymag", 0}, {"znear", 0}, {"zfar", 1}}}}),
              "test.gltf: camera 0: ymag 0 is not a valid size: the camera is left out");
    EXPECT_EQ(broken({{"type", "perspective"}}), "test.gltf: camera 0: perspective is missing: left out");
    EXPECT_EQ(broken({{"type", "fisheye"}}),
              "test.gltf: camera 0: type \"fisheye\" is not defined by glTF: left out");
    EXPECT_EQ(broken({{"type", "perspective"}, {"perspective", {{"znear", 1}}}}),
              "test.gltf: camera 0, perspective: yfov is missing: left out");
    GltfBuilder missing = with_camera(lens, json::object());
    missing.document["nodes"][1]["camera"] = 4;
    EXPECT_EQ(complaint(missing), "test.gltf: camera 4 does not exist: the camera is left out");
    Warnings warnings;
    EXPECT_TRUE(load(with_camera(lens, {{"scale", {1, 1, 0}}}), &warnings).cameras.empty());
    EXPECT_TRUE(warned_once(warnings, "node 1: its camera has no direction: left out"));
}

// "A node is visible if and only if its own visible property is true and all its parents are visible"; "visibility affects
// neither cameras". [KHR_node_visibility]
TEST(GltfNodes, HiddenOnesHideTheirMeshesAndLightsAndThoseBelow)
{
    GltfBuilder builder = triangle();
    const auto visible = [](bool is) { return json{{"KHR_node_visibility", {{"visible", is}}}}; };
    json& nodes = builder.document["nodes"];
    nodes[0]["extensions"] = visible(true);
    nodes.push_back({{"mesh", 0}, {"extensions", visible(false)}, {"children", {2}}});
    nodes.push_back({{"mesh", 0}, {"extensions", visible(true)}, {"children", {3}}});
    nodes.push_back({{"camera", 0}, {"name", "below"}, {"mesh", 0}});
    nodes[3]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    builder.document["cameras"] = json::array({lens});
    builder.document["extensions"]["KHR_lights_punctual"]["lights"] = json::array({{{"type", "point"}}});
    builder.document["scenes"] = json::array({{{"nodes", {0, 1}}}});
    builder.document["extensionsUsed"] = {"KHR_node_visibility", "KHR_lights_punctual"};
    builder.document["extensionsRequired"] = {"KHR_node_visibility"};
    Warnings warnings;
    Scene scene = load(builder, &warnings);
    EXPECT_EQ(warnings, Warnings());
    EXPECT_EQ(scene.instances.size(), 1u);
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_EQ(scene.cameras.at(0).name, "below");
    nodes[1]["extensions"] = {{"KHR_node_visibility", json::object()}};
    scene = load(builder);
    EXPECT_EQ(scene.instances.size(), 4u);
    EXPECT_EQ(scene.lights.size(), 1u);
}

GltfBuilder with_light(const json& light, const json& node)
{
    GltfBuilder builder = triangle();
    builder.document["extensions"]["KHR_lights_punctual"]["lights"] = json::array({light});
    json complete = node;
    complete["extensions"]["KHR_lights_punctual"]["light"] = 0;
    builder.add_node(complete);
    return builder;
}

TEST(GltfLights, TheThreeKinds)
{
    const double half = std::sqrt(0.5); // a quarter turn about +X takes -Z to +Y
    const json node = {{"translation", {1, 2, 3}}, {"rotation", {half, 0, 0, half}}, {"scale", {5, 5, 5}}};
    const Light sun =
        load(with_light({{"type", "directional"}, {"color", {1, 0.5, 0.25}}, {"intensity", 4}}, node))
            .lights.at(0);
    EXPECT_EQ(sun.kind, LightKind::directional);
    EXPECT_EQ(sun.intensity, glm::vec3(4, 2, 1));
    expect_near(sun.direction, {0, 1, 0});

    const Light lamp = load(with_light({{"type", "point"}, {"range", 7}}, node)).lights.at(0);
    EXPECT_EQ(lamp.kind, LightKind::point);
    EXPECT_EQ(lamp.intensity, glm::vec3(1));
    EXPECT_EQ(lamp.position, glm::vec3(1, 2, 3));
    EXPECT_EQ(lamp.range, 7.0f);

    const Light spot =
        load(with_light({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}},
                        node))
            .lights.at(0);
    EXPECT_EQ(spot.kind, LightKind::spot);
    EXPECT_EQ(spot.inner_cone, 0.25f);
    EXPECT_EQ(spot.outer_cone, 0.5f);
    EXPECT_EQ(spot.range, std::numeric_limits<float>::infinity());
    expect_near(spot.direction, {0, 1, 0});

    const Light plain_spot =
        load(with_light({{"type", "spot"}, {"spot", json::object()}}, node)).lights.at(0);
    EXPECT_EQ(plain_spot.inner_cone, 0.0f);
    EXPECT_NEAR(plain_spot.outer_cone, std::numbers::pi / 4, 1e-6);
}

TEST(GltfLights, ImpossibleOnesAreLeftOut)
{
    const auto broken = [](const json& light) {
        const GltfBuilder builder = with_light(light, json::object());
        EXPECT_TRUE(load(builder).lights.empty());
        return complaint(builder);
    };
    EXPECT_EQ(broken({{"type", "area"}}),
              "test.gltf: light 0: type \"area\" is not known: the light is left out");
    EXPECT_EQ(
        broken({{"type", "point"}, {"intensity", -1}}),
        "test.gltf: light 0: its intensity times colour is negative or too large: the light is left out");
    EXPECT_EQ(broken({{"type", "spot"}, {"spot", {{"outerConeAngle", 0}}}}),
              "test.gltf: light 0: outerConeAngle 0 is not above 0: the light is left out");
    EXPECT_EQ(broken({{"intensity", 3}}),
              "test.gltf: extensions, KHR_lights_punctual, light 0: type is missing: left out");
    GltfBuilder missing = with_light({{"type", "point"}}, json::object());
    missing.document["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 9;
    EXPECT_EQ(complaint(missing), "test.gltf: light 9 does not exist: the light is left out");
    // A node that is not drawn carries no light.
    GltfBuilder dark = with_light({{"type", "point"}}, json::object());
    dark.document["scenes"][0]["nodes"] = {0};
    EXPECT_TRUE(load(dark).lights.empty());
}

TEST(GltfLights, ValuesOutOfRangeAreClampedOrLeftOut)
{
    const auto mended = [](const json& light, const char* warning) {
        const GltfBuilder builder = with_light(light, json::object());
        EXPECT_EQ(complaint(builder), warning);
        return load(builder).lights.at(0);
    };
    const Light swapped =
        mended({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.6}, {"outerConeAngle", 0.5}}}},
               "test.gltf: light 0: cone angles 0.6 and 0.5 are not 0 <= inner <= outer <= "
               "pi/2: 0.5 and 0.5 are used");
    EXPECT_EQ(swapped.inner_cone, 0.5f);
    EXPECT_EQ(swapped.outer_cone, 0.5f);
    const Light wide = mended({{"type", "spot"}, {"spot", {{"outerConeAngle", 2}}}},
                              "test.gltf: light 0: cone angles 0 and 2 are not 0 <= inner <= outer <= pi/2: "
                              "0 and 1.5708 are used");
    EXPECT_NEAR(wide.outer_cone, std::numbers::pi / 2, 1e-6);
    const Light endless =
        mended({{"type", "point"}, {"range", -1}}, "test.gltf: light 0: range -1 is negative: ignored");
    EXPECT_EQ(endless.range, std::numeric_limits<float>::infinity());
    const Light white = mended({{"type", "point"}, {"color", {1, 1}}},
                               "test.gltf: extensions, KHR_lights_punctual, light 0: color has 2 numbers, "
                               "not 3: ignored");
    EXPECT_EQ(white.intensity, glm::vec3(1));
    const GltfBuilder bare = with_light({{"type", "spot"}}, json::object());
    EXPECT_NEAR(load(bare).lights.at(0).outer_cone, std::numbers::pi / 4, 1e-6) << "the usual cone";
}

} // namespace
} // namespace lambent::scene::test
