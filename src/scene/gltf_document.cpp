#include "scene/gltf_document.h"

#include "base/file.h"
#include "scene/gltf_container.h"
#include "scene/gltf_json.h"
#include "scene/gltf_uri.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace lambent::scene {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 7> supported = {
    "KHR_lights_punctual", "KHR_texture_transform", "KHR_materials_emissive_strength",
    "KHR_materials_unlit", "KHR_mesh_quantization", "EXT_mesh_gpu_instancing",
    "KHR_node_visibility"};

// No outside file of a scene is larger than this.
constexpr std::uint64_t largest_file = std::uint64_t{1} << 33;

// The names in an array of the document that are not supported, joined with commas.
std::string unsupported(const json& document, const char* array)
{
    std::string names;
    const auto list = document.find(array);
    if (list == document.end() || !list->is_array())
        return names;
    for (const json& entry : *list) {
        if (!entry.is_string())
            continue;
        const auto& name = entry.get_ref<const std::string&>();
        if (std::find(supported.begin(), supported.end(), name) == supported.end())
            names += (names.empty() ? "" : ", ") + printable(name);
    }
    return printable(names);
}

// Before the schema: an extension that changes it should be named, not its consequences.
void check_extensions(const json& document, const std::string& file, Warnings& warnings)
{
    if (const std::string names = unsupported(document, "extensionsRequired"); !names.empty())
        refuse(file, ": needs extensions that are not supported: ", names);
    if (const std::string names = unsupported(document, "extensionsUsed"); !names.empty())
        warnings.push_back(text(file, ": extensions ignored: ", names));
}

void check_version(const json& document, const std::string& file)
{
    const json& asset = document.at("asset");
    const auto& version = asset.at("version").get_ref<const std::string&>();
    if (!version.starts_with("2."))
        refuse(file, ": glTF version ", printable(version), " is not read, only 2.0");
    if (asset.contains("minVersion") && asset.at("minVersion") != "2.0")
        refuse(file, ": needs glTF ", printable(asset.at("minVersion").get_ref<const std::string&>()),
               ", only 2.0 is read");
}

// tinygltf wants the member, glTF does not; -1 is its way to say "none".
void fill_in_for_tinygltf(json& document)
{
    if (!document.contains("skins"))
        return;
    for (json& skin : document.at("skins"))
        skin.emplace("inverseBindMatrices", -1);
}

// Removes an array from the document, so that it is neither written out nor parsed again.
json take(json& document, const char* name)
{
    const auto found = document.find(name);
    if (found == document.end())
        return json::array();
    json taken = std::move(*found);
    document.erase(found);
    return taken;
}

std::vector<ImageSource> take_images(json& document, const std::string& file)
{
    std::vector<ImageSource> images;
    for (json& image : take(document, "images")) {
        ImageSource source;
        if (image.contains("uri") == image.contains("bufferView"))
            refuse(file, ": image ", images.size(), ": needs either a uri or a bufferView");
        if (image.contains("uri"))
            source.uri = std::move(image.at("uri").get_ref<std::string&>());
        else
            source.buffer_view = image.at("bufferView").get<int>();
        if (image.contains("name"))
            source.name = std::move(image.at("name").get_ref<std::string&>());
        images.push_back(std::move(source));
    }
    return images;
}

// tinygltf refuses a channel without a node, and spends a kilobyte on each.
std::vector<AnimationSource> take_animations(json& document)
{
    std::vector<AnimationSource> animations;
    for (json& animation : take(document, "animations")) {
        AnimationSource source;
        source.name = animation.value("name", "");
        for (const json& channel : take(animation, "channels")) {
            const json& target = channel.at("target");
            source.channels.push_back({channel.at("sampler").get<int>(), target.value("node", -1),
                                       target.at("path").get<std::string>()});
        }
        for (const json& sampler : take(animation, "samplers"))
            source.samplers.push_back({sampler.at("input").get<int>(), sampler.at("output").get<int>(),
                                       sampler.value("interpolation", "LINEAR")});
        animations.push_back(std::move(source));
    }
    return animations;
}

// One buffer's bytes: of a data URI, of a file, or of the BIN chunk (the first buffer, without uri).
BufferBytes open_buffer(const json& buffer, std::span<const std::uint8_t> binary, Document& document)
{
    const std::size_t index = document.buffers.size();
    const std::string where = text(document.file, ": buffer ", index);
    std::span<const std::uint8_t> bytes = binary;
    if (buffer.contains("uri")) {
        const auto& uri = buffer.at("uri").get_ref<const std::string&>();
        document.storage.push_back(is_data_uri(uri) ? decode_data_uri(uri, where)
                                                    : read_beside(document.folder, uri, where));
        bytes = document.storage.back();
    } else if (index != 0 || binary.data() == nullptr) {
        return {};
    }
    const auto length = buffer.at("byteLength").get<std::uint64_t>();
    if (length > bytes.size())
        refuse(where, ": ", length, " bytes declared, ", bytes.size(), " are there");
    return {bytes.first(length), true};
}

// What cannot be a file is said where it is wanted.
void note_beside(const std::string& uri, Document& document)
{
    if (uri.empty() || is_data_uri(uri) || !document.folder)
        return;
    try {
        document.beside.push_back(*document.folder / relative_path(uri, document.file));
    } catch (const Error&) {
    }
}

} // namespace

std::uint64_t Document::buffer_bytes() const
{
    std::uint64_t sum = 0;
    for (const BufferBytes& buffer : buffers)
        sum += buffer.bytes.size();
    return sum;
}

std::vector<std::uint8_t> read_beside(const std::optional<std::filesystem::path>& folder,
                                      const std::string& uri, const std::string& where)
{
    const std::filesystem::path path = relative_path(uri, where);
    if (!folder)
        refuse(where, ": \"", printable(uri), "\" is outside the file");
    try {
        return read_file(*folder / path, largest_file);
    } catch (const Error& error) {
        throw Error(error.failure(), text(where, ": ", printable(error.what())));
    }
}

std::span<const std::uint8_t> view_bytes(const Document& document, int buffer_view, const std::string& what)
{
    const auto& views = document.model.bufferViews;
    if (buffer_view < 0 || static_cast<std::size_t>(buffer_view) >= views.size())
        document.fail(what, ": bufferView ", buffer_view, " does not exist");
    const tinygltf::BufferView& view = views[static_cast<std::size_t>(buffer_view)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= document.buffers.size())
        document.fail("bufferView ", buffer_view, ": buffer ", view.buffer, " does not exist");
    const BufferBytes& buffer = document.buffers[static_cast<std::size_t>(view.buffer)];
    if (!buffer.present)
        document.fail("bufferView ", buffer_view, ": buffer ", view.buffer, " has no bytes");
    const std::size_t size = buffer.bytes.size();
    if (view.byteOffset > size || view.byteLength > size - view.byteOffset)
        document.fail("bufferView ", buffer_view, ": ", view.byteLength, " bytes at ", view.byteOffset,
                      " do not fit in buffer ", view.buffer, " (", size, " bytes)");
    return buffer.bytes.subspan(view.byteOffset, view.byteLength);
}

Document open_document(const GltfSource& source, Warnings& warnings)
{
    const Container container = open_container(source.bytes, source.file);
    json parsed = parse_gltf_json(container.json, source.file);
    check_extensions(parsed, source.file, warnings);
    check_schema(parsed, source.file);
    check_version(parsed, source.file);

    Document document;
    document.file = source.file;
    document.folder = source.folder;
    document.images = take_images(parsed, source.file);
    document.animations = take_animations(parsed);
    const json buffers = take(parsed, "buffers");
    fill_in_for_tinygltf(parsed);
    document.model = parse_model(parsed.dump(), source.file);
    for (const json& buffer : buffers) {
        note_beside(buffer.value("uri", ""), document);
        document.buffers.push_back(open_buffer(buffer, container.binary, document));
    }
    for (const ImageSource& image : document.images)
        note_beside(image.uri, document);
    return document;
}

} // namespace lambent::scene
