#include "tests/scene/gltf_builder.h"

#include "base/text.h"
#include "scene/gltf/gltf.h"

#include <algorithm>

namespace lambent::scene::test {
namespace {

void append_u32(Bytes& bytes, std::size_t value)
{
    for (int shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

} // namespace

std::size_t components_of(std::string_view type)
{
    if (type == "SCALAR")
        return 1;
    if (type == "MAT4")
        return 16;
    return static_cast<std::size_t>(type.back() - '0');
}

int GltfBuilder::add_to(const char* array, const json& element)
{
    document[array].push_back(element);
    return static_cast<int>(document[array].size()) - 1;
}

int GltfBuilder::add_view(const Bytes& bytes, std::size_t stride)
{
    binary.resize((binary.size() + 3) / 4 * 4);
    json view = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}};
    if (stride != 0)
        view["byteStride"] = stride;
    binary.insert(binary.end(), bytes.begin(), bytes.end());
    return add_to("bufferViews", view);
}

int GltfBuilder::add_accessor(const NewAccessor& accessor, const Bytes& bytes)
{
    json entry = {{"bufferView", add_view(bytes, accessor.stride)},
                  {"componentType", accessor.component},
                  {"count", accessor.count},
                  {"type", accessor.type}};
    if (accessor.normalized)
        entry["normalized"] = true;
    return add_to("accessors", entry);
}

int GltfBuilder::add_node(const json& node)
{
    const int index = add_to("nodes", node);
    document["scenes"][0]["nodes"].push_back(index);
    return index;
}

int GltfBuilder::add_primitive(const json& primitive)
{
    const int mesh = add_to("meshes", {{"primitives", json::array({primitive})}});
    add_node({{"mesh", mesh}});
    return mesh;
}

json GltfBuilder::with_buffer(bool data_uri) const
{
    json complete = document;
    if (binary.empty() || complete.contains("buffers"))
        return complete;
    json buffer = {{"byteLength", binary.size()}};
    if (data_uri)
        buffer["uri"] = "data:application/octet-stream;base64," + base64(binary);
    complete["buffers"] = json::array({buffer});
    return complete;
}

Bytes GltfBuilder::glb() const
{
    return make_glb(with_buffer(false).dump(), binary);
}

Bytes GltfBuilder::gltf() const
{
    return to_bytes(with_buffer(true).dump());
}

Bytes to_bytes(std::string_view text)
{
    return {text.begin(), text.end()};
}

std::string base64(const Bytes& bytes)
{
    const std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string code;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) { return k < bytes.size() ? bytes[k] : 0u; };
        const unsigned triple = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
        for (unsigned digit = 0; digit < 4; ++digit)
            code += i + digit > bytes.size() ? '=' : alphabet[triple >> (18 - 6 * digit) & 63];
    }
    return code;
}

Bytes make_glb(std::string_view json_text, const Bytes& binary)
{
    std::string padded(json_text);
    padded.resize((padded.size() + 3) / 4 * 4, ' ');
    Bytes padded_binary = binary;
    padded_binary.resize((binary.size() + 3) / 4 * 4);
    Bytes glb = to_bytes("glTF");
    append_u32(glb, 2);
    append_u32(glb, 12 + 8 + padded.size() + (binary.empty() ? 0 : 8 + padded_binary.size()));
    append_u32(glb, padded.size());
    append_u32(glb, 0x4E4F534A);
    glb.insert(glb.end(), padded.begin(), padded.end());
    if (!binary.empty()) {
        append_u32(glb, padded_binary.size());
        append_u32(glb, 0x004E4942);
        glb.insert(glb.end(), padded_binary.begin(), padded_binary.end());
    }
    return glb;
}

GltfBuilder triangle()
{
    GltfBuilder builder;
    const int positions = builder.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    builder.add_primitive({{"attributes", {{"POSITION", positions}}}});
    return builder;
}

Scene load(const Bytes& bytes, Warnings* warnings, const std::filesystem::path& folder)
{
    Warnings unread;
    GltfSource source{"test.gltf", bytes, std::nullopt};
    if (!folder.empty())
        source.folder = folder;
    return load_gltf_bytes(source, warnings ? *warnings : unread);
}

Scene load(const GltfBuilder& builder, Warnings* warnings)
{
    return load(builder.glb(), warnings);
}

std::string complaint(const Bytes& bytes)
{
    Warnings warnings;
    try {
        load(bytes, &warnings);
    } catch (const Error& error) {
        return text("refused: ", error.what());
    }
    if (warnings.size() > 1)
        return text(warnings.size(), " warnings: ", warnings[0], "; ", warnings[1]);
    return warnings.empty() ? std::string() : warnings.front();
}

std::string complaint(const GltfBuilder& builder)
{
    return complaint(builder.glb());
}

std::string refusal(const Bytes& bytes)
{
    try {
        load(bytes);
    } catch (const Error& error) {
        return error.failure() == Failure::bad_input ? error.what() : "another kind of failure";
    }
    return {};
}

std::string refusal(const GltfBuilder& builder)
{
    return refusal(builder.glb());
}

bool contains(std::string_view text, std::string_view part)
{
    return text.find(part) != std::string_view::npos;
}

bool warned_once(const Warnings& warnings, std::string_view part)
{
    return std::count_if(warnings.begin(), warnings.end(),
                         [&](const std::string& line) { return contains(line, part); }) == 1;
}

} // namespace lambent::scene::test
