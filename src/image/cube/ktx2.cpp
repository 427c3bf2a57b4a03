#include "image/cube/cube_files.h"

#include "base/file.h"
#include "image/cube/cube_texels.h"
#include "image/cube/ktx2_descriptor.h"
#include "image/refuse.h"
#include "image/cube/zstd.h"

#include <algorithm>
#include <iterator>

namespace lambent::image {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t identifier[] = {0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n'};
constexpr std::uint64_t header_bytes = 80, level_index_bytes = 24;
constexpr std::uint32_t zstd_scheme = 2;

// Appends a key and its value. The stored length includes the zeros that end both, but not the padding.
void append_pair(Bytes& bytes, const std::string& key, const std::string& value)
{
    append(bytes, static_cast<std::uint32_t>(key.size() + value.size() + 2));
    for (const std::string& part : {key, value}) {
        bytes.insert(bytes.end(), part.begin(), part.end());
        bytes.push_back(0);
    }
    bytes.resize((bytes.size() + 3) / 4 * 4);
}

// Keys that begin with KTX or ktx are reserved; a cube map in a Vulkan format may have three of them.
void check_key(const std::string& key)
{
    const bool own = key.starts_with("KTX") || key.starts_with("ktx");
    if (key.empty() || key.find('\0') != std::string::npos ||
        (own && key != "KTXwriter" && key != "KTXwriterScParams" && key != "KTXorientation"))
        throw Error(Failure::usage,
                    text("KTX 2 does not allow metadata with the key '", printable(key), "'"));
}

// The format requires keys sorted by code points. In UTF-8 that is the order of their bytes, and so the map's.
Bytes key_values(std::map<std::string, std::string> metadata)
{
    metadata.emplace("KTXwriter", "lambent");
    const auto [orientation, is_new] = metadata.emplace("KTXorientation", "rd");
    if (orientation->second != "rd")
        throw Error(Failure::usage, text("the faces of a cube map in KTX 2 have the orientation 'rd', not '",
                                         printable(orientation->second), "'"));
    Bytes bytes;
    for (const auto& [key, value] : metadata) {
        check_key(key);
        append_pair(bytes, key, value);
    }
    return bytes;
}

// An entry of the level index, in bytes.
struct LevelIndexEntry {
    std::uint64_t offset = 0, length = 0, uncompressed = 0;
};

// Appends the six faces of a level to the file.
LevelIndexEntry append_level(Bytes& file, const CubeMap& map, int level, const Ktx2Options& options)
{
    const std::uint64_t length = 6 * face_bytes(map, level, options.format);
    if (options.zstd) {
        Bytes raw;
        raw.reserve(length);
        for (int face = 0; face < 6; ++face)
            append_texels(map.face(level, face), options.format, raw);
        const std::uint64_t offset = file.size();
        const Bytes packed = compress_zstd(raw);
        file.insert(file.end(), packed.begin(), packed.end());
        return {offset, packed.size(), length};
    }
    // The format requires the least common multiple of the texel size and 4; all texel sizes are multiples of 4.
    const std::size_t alignment = texel_bytes(options.format);
    file.resize((file.size() + alignment - 1) / alignment * alignment);
    const std::uint64_t offset = file.size();
    for (int face = 0; face < 6; ++face)
        append_texels(map.face(level, face), options.format, file);
    return {offset, length, length};
}

Bytes header(const CubeMap& map, const Ktx2Options& options, std::size_t descriptor, std::size_t pairs)
{
    const Ktx2Format format = ktx2_format(options.format);
    const auto size = static_cast<std::uint32_t>(map.size), levels = static_cast<std::uint32_t>(map.levels);
    const auto descriptor_at = static_cast<std::uint32_t>(header_bytes + levels * level_index_bytes);
    Bytes bytes(std::begin(identifier), std::end(identifier));
    for (const std::uint32_t word :
         {format.vk_format, format.type_size, size, size, /* pixelDepth */ 0u, /* layerCount */ 0u,
          /* faceCount */ 6u, levels, options.zstd ? zstd_scheme : 0u, descriptor_at,
          static_cast<std::uint32_t>(descriptor), static_cast<std::uint32_t>(descriptor_at + descriptor),
          static_cast<std::uint32_t>(pairs)})
        append(bytes, word);
    append(bytes, std::uint64_t{0}); // no supercompression global data
    append(bytes, std::uint64_t{0});
    return bytes;
}

} // namespace

std::vector<std::uint8_t> encode_ktx2(const CubeMap& map, const Ktx2Options& options)
{
    check_cube_map(map);
    const Bytes descriptor = ktx2_descriptor(options.format), pairs = key_values(options.metadata);
    Bytes file = header(map, options, descriptor.size(), pairs.size());
    const std::size_t index_at = file.size();
    file.resize(index_at + static_cast<std::size_t>(map.levels) * level_index_bytes);
    if (!options.zstd)
        file.reserve(file.size() + descriptor.size() + pairs.size() +
                     map.values.size() / 3 * texel_bytes(options.format) + 16);
    file.insert(file.end(), descriptor.begin(), descriptor.end());
    file.insert(file.end(), pairs.begin(), pairs.end());

    std::vector<LevelIndexEntry> entries(static_cast<std::size_t>(map.levels));
    for (std::size_t level = entries.size(); level-- > 0;) // smallest level first
        entries[level] = append_level(file, map, static_cast<int>(level), options);
    Bytes index;
    for (const LevelIndexEntry& entry : entries)
        for (const std::uint64_t number : {entry.offset, entry.length, entry.uncompressed})
            append(index, number);
    std::copy(index.begin(), index.end(), file.begin() + static_cast<std::ptrdiff_t>(index_at));
    return file;
}

void write_ktx2(const CubeMap& map, const Ktx2Options& options, const std::filesystem::path& path)
{
    check_can_write(path);
    write_file(path, encode_ktx2(map, options));
}

} // namespace lambent::image
