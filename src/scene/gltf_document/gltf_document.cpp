#include "scene/gltf_document/gltf_document.h"

#include "base/file.h"
#include "scene/gltf_document/gltf_material_path.h"
#include "scene/gltf_document/gltf_container.h"
#include "scene/gltf_document/gltf_json.h"
#include "scene/gltf_document/gltf_losses.h"
#include "scene/gltf_document/gltf_reader.h"
#include "scene/gltf_document/gltf_schema.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace lambent::scene {
namespace {

using nlohmann::json;

// Extensions of materials are those in the list of parameters; the others are listed here.
bool is_supported(std::string_view extension)
{
    constexpr std::string_view others[] = {
        "KHR_lights_punctual", "KHR_texture_transform", "KHR_materials_emissive_strength",
        "KHR_materials_unlit", "KHR_mesh_quantization", "EXT_mesh_gpu_instancing",
        "KHR_node_visibility"};
#define ROW(object)                                                                                          \
    if (extension == #object)                                                                                \
        return is_extension(extension);
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) ROW(object)
#define COLOR(name, number, value, object, key, texture) ROW(object)
#define SCALAR(name, number, value, object, key, texture, channel) ROW(object)
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) ROW(object)
#define STRENGTH(name, factor, number, value, object, key, texture, channel) ROW(object)
#include "shading/material/parameters.h"
#undef ROW
    return std::find(std::begin(others), std::end(others), extension) != std::end(others);
}

// The largest size of a file beside the glTF, in bytes.
constexpr std::uint64_t largest_file = std::uint64_t{1} << 33;

// Limit of the structs of a document, in bytes: a constant, and a multiple of its text. A node of {"mesh":0} takes 30
// times its text, an empty one 100 times.
constexpr std::uint64_t free_bytes = std::uint64_t{1} << 28;
constexpr std::uint64_t bytes_per_character = 32;

// The unsupported extensions in an array of the document, joined with commas.
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
        if (!is_supported(name))
            names += (names.empty() ? "" : ", ") + printable(name);
    }
    return printable(names);
}

// Runs before the schema is checked: an extension that changes it should be reported instead of the resulting faults.
void check_extensions(const json& document, const std::string& file, Warnings& warnings)
{
    if (const std::string names = unsupported(document, "extensionsRequired"); !names.empty())
        refuse(file, ": requires extensions that are not supported: ", names);
    if (const std::string names = unsupported(document, "extensionsUsed"); !names.empty())
        warnings.push_back(text(file, ": extensions ignored: ", names));
}

// Recognises glTF 1.0 by its version or, without one, by its lists, which are objects.
bool is_gltf_1(const json& document, const std::string& version)
{
    if (!version.empty())
        return version.starts_with("1.") || version == "1" || version.starts_with("0.");
    const auto nodes = document.find("nodes");
    return nodes != document.end() && nodes->is_object();
}

// Runs before the schema is checked, which is that of 2.0.
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
        refuse(file, ": glTF 1.0 is not supported, only 2.0");
    if (!has_asset)
        refuse(file, ": asset is missing");
    if (version.empty())
        refuse(file, ": asset: version is missing");
    if (!version.starts_with("2."))
        refuse(file, ": glTF version ", version, " is not supported, only 2.0");
    if (asset->contains("minVersion") && asset->at("minVersion") != "2.0")
        refuse(file, ": requires glTF ", word("minVersion"), ", only 2.0 is supported");
}

// The bytes of a buffer: from a data URI, a file, or the BIN chunk (for the first buffer, without uri).
BufferBytes open_buffer(const gltf::Buffer& buffer, std::span<const std::uint8_t> binary, Document& document,
                        Losses& losses)
{
    const std::size_t index = document.buffers.size();
    const std::string where = text(document.file, ": buffer ", index);
    std::span<const std::uint8_t> bytes = binary;
    if (buffer.uri) {
        document.storage.push_back(is_data_uri(*buffer.uri) ? decode_data_uri(*buffer.uri, where)
                                                            : read_beside(document.base, *buffer.uri, where));
        bytes = document.storage.back();
    } else if (index != 0 || binary.data() == nullptr) {
        return {};
    }
    const std::uint64_t length = buffer.byte_length;
    if (length > bytes.size()) {
        const std::string fault =
            text(where, ": ", length, " bytes declared, only ", bytes.size(), " present");
        losses.add(fault, "these are used");
        if (document.first_loss.empty())
            document.first_loss = fault;
    }
    return {bytes.first(std::min<std::uint64_t>(length, bytes.size())), true};
}

void open_buffers(std::span<const std::uint8_t> binary, Document& document, Losses& losses)
{
    for (gltf::Buffer& buffer : document.model.buffers) {
        BufferBytes opened;
        try {
            opened = open_buffer(buffer, binary, document, losses);
        } catch (const Error& error) {
            opened = {}; // GCC 12 does not keep the default where open_buffer() throws
            losses.add(error.what(), "left out");
            if (document.first_loss.empty())
                document.first_loss = error.what();
        }
        document.buffers.push_back(opened);
        buffer.uri.reset(); // frees the text of data URIs
    }
}

// Adds the path of a uri to document.beside. Invalid ones are reported when they are read.
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
    const auto& views = document.model.buffer_views;
    if (buffer_view < 0 || static_cast<std::size_t>(buffer_view) >= views.size())
        document.fail(what, ": bufferView ", buffer_view, " does not exist");
    const gltf::BufferView& view = views[static_cast<std::size_t>(buffer_view)];
    if (view.is_broken)
        throw told_already();
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= document.buffers.size())
        document.fail("bufferView ", buffer_view, ": buffer ", view.buffer, " does not exist");
    const BufferBytes& buffer = document.buffers[static_cast<std::size_t>(view.buffer)];
    if (!buffer.present)
        document.fail("bufferView ", buffer_view, ": buffer ", view.buffer, " has no bytes");
    const std::size_t size = buffer.bytes.size();
    if (view.byte_offset > size || view.byte_length > size - view.byte_offset)
        document.fail("bufferView ", buffer_view, ": ", view.byte_length, " bytes at ", view.byte_offset,
                      " do not fit in buffer ", view.buffer, " (", size, " bytes)");
    return buffer.bytes.subspan(view.byte_offset, view.byte_length);
}

Document open_document(const GltfSource& source, Warnings& warnings)
{
    const Container container = open_container(source.bytes, source.file);
    json parsed = parse_json(container.json, document_shape(), source.file);
    check_version(parsed, source.file);
    check_extensions(parsed, source.file, warnings);

    Document document;
    Losses losses(source.file, warnings);
    document.file = source.file;
    document.base = {source.folder, source.reach};
    const std::uint64_t most_bytes = free_bytes + bytes_per_character * container.json.size();
    document.first_loss =
        read_document(parsed, document_shape(), &document.model, {source.file, losses, most_bytes});
    for (const gltf::Buffer& buffer : document.model.buffers)
        note_beside(buffer.uri.value_or(""), document);
    open_buffers(container.binary, document, losses);
    for (const gltf::Image& image : document.model.images)
        note_beside(image.uri, document);
    return document;
}

} // namespace lambent::scene
