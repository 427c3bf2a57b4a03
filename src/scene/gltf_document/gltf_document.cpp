#include "scene/gltf_document/gltf_document.h"

#include "base/file.h"
#include "scene/gltf_document/gltf_container.h"
#include "scene/gltf_document/gltf_json.h"
#include "scene/gltf_document/gltf_losses.h"
#include "scene/gltf_document/gltf_parts.h"

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

// The lists of glTF 1.0 are objects.
bool is_gltf_1(const json& document, const std::string& version)
{
    if (!version.empty())
        return version.starts_with("1.") || version == "1" || version.starts_with("0.");
    const auto nodes = document.find("nodes");
    return nodes != document.end() && nodes->is_object();
}

// Before the schema, which is that of 2.0.
void check_version(const json& document, const std::string& file)
{
    const auto asset = document.find("asset");
    const bool has_asset = asset != document.end() && asset->is_object();
    const auto word = [&](const char* name) {
        return has_asset && asset->contains(name) && asset->at(name).is_string()
                   ? printable(asset->at(name).get_ref<const std::string&>())
                   : std::string();
    };
    const std::string version = word("version");
    if (is_gltf_1(document, version))
        refuse(file, ": glTF 1.0 is not read, only 2.0");
    if (!has_asset)
        refuse(file, ": asset is missing");
    if (version.empty())
        refuse(file, ": asset: version is missing");
    if (!version.starts_with("2."))
        refuse(file, ": glTF version ", version, " is not read, only 2.0");
    if (asset->contains("minVersion") && asset->at("minVersion") != "2.0")
        refuse(file, ": needs glTF ", word("minVersion"), ", only 2.0 is read");
}

// tinygltf wants members that glTF does not, or not of lights without a cone; -1 is its way to say "none".
void fill_in_for_tinygltf(json& document)
{
    if (document.contains("skins"))
        for (json& skin : document.at("skins"))
            skin.emplace("inverseBindMatrices", -1);
    const json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
    if (document.contains(lights))
        for (json& light : document.at(lights))
            light.emplace("spot", json::object());
}

// One buffer's bytes: of a data URI, of a file, or of the BIN chunk (the first buffer, without uri).
BufferBytes open_buffer(const json& buffer, std::span<const std::uint8_t> binary, Document& document,
                        Losses& losses)
{
    const std::size_t index = document.buffers.size();
    const std::string where = text(document.file, ": buffer ", index);
    std::span<const std::uint8_t> bytes = binary;
    if (buffer.contains("uri")) {
        const auto& uri = buffer.at("uri").get_ref<const std::string&>();
        document.storage.push_back(is_data_uri(uri) ? decode_data_uri(uri, where)
                                                    : read_beside(document.base, uri, where));
        bytes = document.storage.back();
    } else if (index != 0 || binary.data() == nullptr) {
        return {};
    }
    const auto length = buffer.at("byteLength").get<std::uint64_t>();
    if (length > bytes.size()) {
        const std::string fault = text(where, ": ", length, " bytes declared, ", bytes.size(), " are there");
        losses.add(fault, "used as far as they go");
        if (document.first_loss.empty())
            document.first_loss = fault;
    }
    return {bytes.first(std::min<std::uint64_t>(length, bytes.size())), true};
}

void open_buffers(const json& buffers, std::span<const std::uint8_t> binary, Document& document,
                  Losses& losses)
{
    for (const json& buffer : buffers) {
        BufferBytes opened;
        try {
            opened = open_buffer(buffer, binary, document, losses);
        } catch (const Error& error) {
            losses.add(error.what(), "left out");
            if (document.first_loss.empty())
                document.first_loss = error.what();
        }
        document.buffers.push_back(opened);
    }
}

// What cannot be a file is said where it is wanted.
void note_beside(const std::string& uri, Document& document)
{
    if (uri.empty() || is_data_uri(uri) || !document.base.folder)
        return;
    try {
        document.beside.push_back(path_beside(document.base, uri, document.file));
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

bool is_broken(const tinygltf::ExtensionMap& extensions)
{
    return extensions.contains(broken_mark);
}

std::vector<std::uint8_t> read_beside(const UriBase& base, const std::string& uri, const std::string& where)
{
    const std::filesystem::path path = path_beside(base, uri, where);
    check_links(base, path, where);
    try {
        return read_file(path, largest_file);
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
    if (is_broken(view.extensions))
        throw told_already();
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
    check_version(parsed, source.file);
    check_extensions(parsed, source.file, warnings);

    Document document;
    Losses losses(source.file, warnings);
    document.file = source.file;
    document.base = {source.folder, source.reach};
    document.first_loss = check_schema(parsed, source.file, losses);
    document.images = take_images(parsed);
    document.animations = take_animations(parsed);
    const json buffers = take(parsed, "buffers");
    std::vector<tinygltf::Mesh> meshes = take_meshes(parsed);
    const std::vector<std::size_t> strides = take_strides(parsed);
    fill_in_for_tinygltf(parsed);
    document.model = parse_model(parsed.dump(), source.file);
    document.model.meshes = std::move(meshes);
    for (std::size_t view = 0; view < document.model.bufferViews.size(); ++view)
        document.model.bufferViews[view].byteStride = strides.at(view);
    for (const json& buffer : buffers)
        note_beside(buffer.value("uri", ""), document);
    open_buffers(buffers, container.binary, document, losses);
    for (const ImageSource& image : document.images)
        note_beside(image.uri, document);
    return document;
}

} // namespace lambent::scene
