#include "image/cube/zstd.h"

#include "image/cube/cube_files.h"
#include "image/refuse.h"

#ifdef LAMBENT_ZSTD
#include <zstd.h>
#endif

namespace lambent::image {

#ifdef LAMBENT_ZSTD

bool can_write_zstd()
{
    return true;
}

std::vector<std::uint8_t> compress_zstd(std::span<const std::uint8_t> bytes)
{
    // At higher levels, files of half floats take much longer to write and get little smaller.
    constexpr int effort = 9;
    std::vector<std::uint8_t> packed(ZSTD_compressBound(bytes.size()));
    const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), effort);
    if (ZSTD_isError(size))
        throw Error(Failure::cannot_write, text("Zstandard: ", ZSTD_getErrorName(size)));
    packed.resize(size);
    return packed;
}

#else

bool can_write_zstd()
{
    return false;
}

std::vector<std::uint8_t> compress_zstd(std::span<const std::uint8_t>)
{
    throw Error(Failure::usage, "this build cannot compress with Zstandard: it was built without libzstd");
}

#endif

} // namespace lambent::image
