// What of a PNG's chunks its pixels need.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lambent::image {

/// The file's IHDR, PLTE, tRNS and IDAT chunks with their checksums, right or wrong, and an end mark. A last chunk that is
/// cut off ends where the file does. At most 24 bytes longer than the file.
std::vector<std::uint8_t> needed_chunks(std::span<const std::uint8_t> bytes);

} // namespace lambent::image
