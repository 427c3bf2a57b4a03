#include "image/reader.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <sys/mman.h>

namespace lambent::image {
namespace {

// Pixels that read_all_rows reads at a time.
constexpr int band_pixels = 1 << 19;

// Asks for huge pages, because zeroing new small pages takes most of the time of a fast load. This is only
// advice: a system may ignore it.
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
    // The vector grows with the rows that the file really has; each band is decoded while its pages are in the cache.
    const int most = std::max(1, band_pixels / image.width);
    for (int y = 0; y < image.height; y += most) {
        const int count = std::min(most, image.height - y);
        image.values.resize(image.values.size() + row * static_cast<std::size_t>(count));
        reader.read_rows(count, image.pixel(0, y));
    }
    return image;
}

} // namespace lambent::image
