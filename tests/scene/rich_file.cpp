#include "tests/scene/rich_file.h"

#include "tests/scene/png_writer.h"

namespace lambent::scene::test {

GltfBuilder rich_file()
{
    GltfBuilder b;
    const int positions = b.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    const int normals = b.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0});
    const int texcoords = b.add<std::uint16_t>("VEC2", u16, {0, 0, 65535, 0, 0, 65535, 65535, 65535}, true);
    const int indices = b.add<std::uint8_t>("SCALAR", u8, {0, 1, 2, 3});
    const int joints = b.add<std::uint8_t>("VEC4", u8, std::vector<std::uint8_t>(16, 0));
    const int weights = b.add_vec4({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const int moved = b.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int bind = b.add("MAT4", f32, std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    const int sparse_at = b.add_view({1});
    const int sparse_values = b.add_view(bytes_of<float>({2, 0, 0}));
    b.document["accessors"][0]["sparse"] = {{"count", 1},
                                            {"indices", {{"bufferView", sparse_at}, {"componentType", u8}}},
                                            {"values", {{"bufferView", sparse_values}}}};
    b.add_to("images", {{"bufferView", b.add_view(make_png({1, 1, 8, {1, 2, 3, 4}}))}});
    b.add_to("textures", {{"source", 0}, {"sampler", 0}});
    b.add_to("samplers", {{"wrapS", 33071}, {"minFilter", 9984}});
    b.add_to("materials",
             {{"normalTexture",
               {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"rotation", 0.5}}}}}}}});
    b.add_primitive({{"attributes",
                      {{"POSITION", positions},
                       {"NORMAL", normals},
                       {"TEXCOORD_0", texcoords},
                       {"JOINTS_0", joints},
                       {"WEIGHTS_0", weights}}},
                     {"indices", indices},
                     {"material", 0},
                     {"mode", 5},
                     {"targets", {{{"POSITION", moved}}}}});
    b.document["meshes"][0]["weights"] = {0.5};
    b.document["nodes"][0]["skin"] = 0;
    b.document["skins"] = {{{"joints", {1}}, {"inverseBindMatrices", bind}}};
    b.document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    b.document["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"spot", json::object()}}};
    b.add_node({{"camera", 0}, {"rotation", {0, 0, 0, 1}}, {"children", {2}}});
    b.document["nodes"].push_back(
        {{"mesh", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"scale", {1, 2, 3}}});
    const int times = b.add("SCALAR", f32, std::vector<float>{0, 1});
    const int places = b.add_vec3({0, 0, 0, 0, 0, 1});
    const int turns = b.add<std::int16_t>("VEC4", i16, {0, 0, 0, 32767, 0, 32767, 0, 0}, true);
    const int shapes = b.add("SCALAR", f32, std::vector<float>{0, 0, 0, 0, 1, 0});
    const auto channel = [](int sampler, int node, const char* path) {
        return json{{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}};
    };
    b.add_to("animations", {{"channels",
                             {channel(0, 1, "translation"), channel(0, 2, "scale"), channel(1, 1, "rotation"),
                              channel(2, 0, "weights")}},
                            {"samplers",
                             {{{"input", times}, {"output", places}, {"interpolation", "STEP"}},
                              {{"input", times}, {"output", turns}},
                              {{"input", times}, {"output", shapes}, {"interpolation", "CUBICSPLINE"}}}}});
    b.document["nodes"][2]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", places},
                                                                                     {"ROTATION", turns}};
    b.document["nodes"][2]["extensions"]["KHR_node_visibility"]["visible"] = true;
    b.add_primitive({{"attributes", {{"POSITION", places}, {"TEXCOORD_3", places}}}, {"mode", 2}});
    return b;
}

} // namespace lambent::scene::test
