// Extracts the chunks of a PNG that its pixels need.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lambent::image {

/// A PNG of the file's IHDR, PLTE, tRNS and IDAT chunks, with their checksums whether right or wrong, and an IEND. A
/// last chunk that is cut off is shortened to the end of the file. The result is at most 24 bytes longer than the file.
std::vector<std::uint8_t> needed_chunks(std::span<const std::uint8_t> bytes);

} // namespace lambent::image
