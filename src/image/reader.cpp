#include "image/reader.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <sys/mman.h>

namespace lambent::image {
namespace {

// Read at a time by read_all_rows.
constexpr int band_pixels = 1 << 19;

// Most of the time of a fast load goes into the system's clearing of fresh pages, one by one. Only advice:
// nothing is lost when it is not taken.
void ask_for_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes)
{
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t page = std::uintptr_t{1} << 21;
    const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
    const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
    if (begin < end)
        // NOLINTNEXTLINE(performance-no-int-to-ptr): rounding a pointer to whole pages
        ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

} // namespace

RadianceImage read_all_rows(RadianceReader& reader)
{
    RadianceImage image{reader.width(), reader.height(), 3, {}};
    const std::size_t row = static_cast<std::size_t>(image.width) * 3;
    image.values.reserve(row * static_cast<std::size_t>(image.height));
    ask_for_huge_pages(image.values.data(), image.values.capacity() * sizeof(float));
    // Memory is taken as the rows prove to be there, and while they are still in the cache.
    const int most = std::max(1, band_pixels / image.width);
    for (int y = 0; y < image.height; y += most) {
        const int count = std::min(most, image.height - y);
        image.values.resize(image.values.size() + row * static_cast<std::size_t>(count));
        reader.read_rows(count, image.pixel(0, y));
    }
    return image;
}

} // namespace lambent::image
