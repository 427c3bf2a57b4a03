#include "environment/cache/environment_bytes.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstring>
#include <type_traits>

namespace lambent::environment {
namespace {

constexpr std::uint64_t magic = 0x31746e65626d616cu; // "lambent1"
constexpr std::size_t header = 2 * sizeof(std::uint64_t);

class Writer {
public:
    std::vector<std::uint8_t> bytes;

    template <class Value>
    void add(const Value& value)
    {
        static_assert(std::is_trivially_copyable_v<Value>);
        add_all(&value, 1);
    }

    template <class Value>
    void add_all(const Value* values, std::size_t count)
    {
        const auto* from = reinterpret_cast<const std::uint8_t*>(values);
        bytes.insert(bytes.end(), from, from + count * sizeof(Value));
    }
};

// Reads values; beyond the end of the bytes they are zero, and good() is false from then on.
class Reader {
public:
    explicit Reader(std::span<const std::uint8_t> bytes) : left_(bytes) {}

    template <class Value>
    Value get()
    {
        static_assert(std::is_trivially_copyable_v<Value>);
        Value value{};
        get_all(&value, 1);
        return value;
    }

    template <class Value>
    void get_all(Value* values, std::size_t count)
    {
        if (!has<Value>(count)) {
            good_ = false;
            return;
        }
        if (count > 0) // an empty vector's data may be null
            std::memcpy(values, left_.data(), count * sizeof(Value));
        left_ = left_.subspan(count * sizeof(Value));
    }

    template <class Value>
    bool has(std::size_t count) const
    {
        return good_ && count <= left_.size() / sizeof(Value);
    }

    void fail() { good_ = false; }
    bool good() const { return good_; }
    bool finished() const { return good_ && left_.empty(); }

private:
    std::span<const std::uint8_t> left_;
    bool good_ = true;
};

void write(const CubeChain& chain, Writer& writer)
{
    writer.add(std::int32_t{chain.log2_size});
    writer.add(std::int32_t{chain.levels});
    writer.add(chain.scale);
    // Level by level, without the gaps between them.
    for (int level = 0; level < chain.levels; ++level) {
        const int n = chain.face_size(level);
        const std::size_t first = chain.texel(level, 0, -1, -1), end = chain.texel(level, 5, n, n) + 1;
        writer.add_all(chain.halfs() + 3 * first, 3 * (end - first));
    }
}

void read(Reader& reader, CubeChain& chain)
{
    const auto log2_size = reader.get<std::int32_t>(), levels = reader.get<std::int32_t>();
    const auto scale = reader.get<float>();
    const bool possible = log2_size >= 0 && log2_size <= 13 && levels >= 1 && levels <= log2_size + 1;
    const std::size_t least = possible ? 18 * (std::size_t{1} << (2 * log2_size)) : 0;
    if (!possible || !reader.has<std::uint16_t>(least)) {
        reader.fail();
        return;
    }
    chain.allocate(log2_size, levels);
    chain.scale = scale;
    for (int level = 0; level < levels; ++level) {
        const int n = chain.face_size(level);
        const std::size_t first = chain.texel(level, 0, -1, -1), end = chain.texel(level, 5, n, n) + 1;
        reader.get_all(chain.halfs() + 3 * first, 3 * (end - first));
    }
}

void write(const Panorama& panorama, Writer& writer)
{
    writer.add(std::int32_t{panorama.width});
    writer.add(std::int32_t{panorama.height});
    writer.add(panorama.scale);
    writer.add_all(panorama.texels.data(), panorama.texels.size());
}

void read(Reader& reader, Panorama& panorama)
{
    panorama.width = reader.get<std::int32_t>();
    panorama.height = reader.get<std::int32_t>();
    panorama.scale = reader.get<float>();
    const bool possible =
        panorama.width > 0 && panorama.height > 0 && panorama.width <= 1 << 20 && panorama.height <= 1 << 20;
    const std::size_t count =
        possible ? static_cast<std::size_t>(panorama.width) * static_cast<std::size_t>(panorama.height) : 0;
    if (!possible || !reader.has<std::uint32_t>(count)) {
        reader.fail();
        return;
    }
    panorama.texels.resize(count);
    reader.get_all(panorama.texels.data(), count);
}

void write(const Lamps& lamps, Writer& writer)
{
    writer.add(std::int32_t{lamps.last_level});
    writer.add(std::uint64_t{lamps.lamps.size()});
    writer.add_all(lamps.lamps.data(), lamps.lamps.size());
}

void read(Reader& reader, Lamps& lamps)
{
    lamps.last_level = reader.get<std::int32_t>();
    const auto count = static_cast<std::size_t>(reader.get<std::uint64_t>());
    if (!reader.has<Lamp>(count)) {
        reader.fail();
        return;
    }
    lamps.lamps.resize(count);
    reader.get_all(lamps.lamps.data(), count);
}

void write(const Warnings& warnings, Writer& writer)
{
    writer.add(std::uint64_t{warnings.size()});
    for (const std::string& line : warnings) {
        writer.add(std::uint64_t{line.size()});
        writer.add_all(line.data(), line.size());
    }
}

void read(Reader& reader, Warnings& warnings)
{
    const auto count = static_cast<std::size_t>(reader.get<std::uint64_t>());
    for (std::size_t i = 0; i < count && reader.good(); ++i) {
        const auto length = static_cast<std::size_t>(reader.get<std::uint64_t>());
        if (!reader.has<char>(length)) {
            reader.fail();
            return;
        }
        std::string line(length, ' ');
        reader.get_all(line.data(), length);
        warnings.push_back(std::move(line));
    }
}

} // namespace

std::vector<std::uint8_t> to_bytes(const MadeEnvironment& made)
{
    Writer writer;
    writer.bytes.resize(header);
    write(made.environment.panorama, writer);
    write(made.environment.chain, writer);
    write(made.environment.lamps, writer);
    write(made.environment.irradiance, writer);
    write(made.warnings, writer);
    const std::uint64_t start[2] = {magic,
                                    XXH3_64bits(writer.bytes.data() + header, writer.bytes.size() - header)};
    std::memcpy(writer.bytes.data(), start, header);
    return std::move(writer.bytes);
}

std::optional<MadeEnvironment> from_bytes(std::span<const std::uint8_t> bytes)
{
    if (bytes.size() < header)
        return std::nullopt;
    std::uint64_t start[2];
    std::memcpy(start, bytes.data(), header);
    const std::span<const std::uint8_t> rest = bytes.subspan(header);
    if (start[0] != magic || start[1] != XXH3_64bits(rest.data(), rest.size()))
        return std::nullopt;
    MadeEnvironment made;
    Reader reader(rest);
    read(reader, made.environment.panorama);
    if (reader.good())
        read(reader, made.environment.chain);
    if (reader.good())
        read(reader, made.environment.lamps);
    if (reader.good())
        read(reader, made.environment.irradiance);
    if (reader.good())
        read(reader, made.warnings);
    if (!reader.finished())
        return std::nullopt;
    return made;
}

} // namespace lambent::environment
