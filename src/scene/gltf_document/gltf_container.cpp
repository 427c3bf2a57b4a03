#include "scene/gltf_document/gltf_container.h"

#include "scene/gltf_document/gltf_message.h"

#include <cstring>

namespace lambent::scene {
namespace {

constexpr std::uint32_t json_chunk = 0x4E4F534A;
constexpr std::uint32_t binary_chunk = 0x004E4942;
constexpr std::size_t header_size = 12;
constexpr std::size_t chunk_header_size = 8;

std::uint32_t little_endian(std::span<const std::uint8_t> bytes, std::size_t at)
{
    return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8 |
           static_cast<std::uint32_t>(bytes[at + 2]) << 16 | static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

std::string_view as_text(std::span<const std::uint8_t> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunk {
    std::uint32_t kind = 0;
    std::span<const std::uint8_t> bytes;
};

Chunk read_chunk(std::span<const std::uint8_t> glb, std::size_t at, const std::string& file)
{
    if (glb.size() - at < chunk_header_size)
        refuse(file, ": GLB: ", glb.size() - at, " bytes at ", at, " are too few for a chunk header");
    const std::uint32_t length = little_endian(glb, at);
    const std::size_t left = glb.size() - at - chunk_header_size;
    if (length > left)
        refuse(file, ": GLB: chunk at ", at, " declares ", length, " bytes, ", left, " are left");
    return {little_endian(glb, at + 4), glb.subspan(at + chunk_header_size, length)};
}

Container open_glb(std::span<const std::uint8_t> bytes, const std::string& file)
{
    if (bytes.size() < header_size)
        refuse(file, ": GLB: ", bytes.size(), " bytes are too few for the header");
    const std::uint32_t version = little_endian(bytes, 4);
    if (version == 1)
        refuse(file, ": glTF 1.0 is not supported, only 2.0");
    if (version != 2)
        refuse(file, ": GLB: version ", version, " is not 2");
    const std::uint32_t length = little_endian(bytes, 8);
    if (length > bytes.size() || length < header_size)
        refuse(file, ": GLB: the header declares ", length, " bytes, the file has ", bytes.size());
    const auto glb = bytes.first(length);

    const Chunk first = read_chunk(glb, header_size, file);
    if (first.kind != json_chunk)
        refuse(file, ": GLB: the first chunk is not JSON");
    Container container{as_text(first.bytes), {}};
    // Chunks start at multiples of four bytes; up to three bytes of padding may be missing at the end of the file.
    std::size_t at = header_size + chunk_header_size + (first.bytes.size() + 3) / 4 * 4;
    if (at < glb.size()) {
        // Only the second chunk may be BIN; chunks of other kinds belong to extensions and are skipped.
        const Chunk second = read_chunk(glb, at, file);
        if (second.kind == binary_chunk)
            container.binary = second.bytes;
    }
    return container;
}

} // namespace

Container open_container(std::span<const std::uint8_t> bytes, const std::string& file)
{
    if (bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0)
        return open_glb(bytes, file);
    std::string_view json = as_text(bytes);
    if (json.starts_with("\xEF\xBB\xBF"))
        json.remove_prefix(3);
    const std::size_t start = json.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos || json[start] != '{')
        refuse(file, ": neither glTF JSON nor GLB");
    return {json, {}};
}

} // namespace lambent::scene
