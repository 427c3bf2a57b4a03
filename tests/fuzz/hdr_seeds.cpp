// Small valid Radiance pictures for fuzz_hdr to start from: one in each encoding, one in columns.
#include "tests/image/radiance_writer.h"

#include <filesystem>
#include <fstream>

int main(int argc, char** argv)
{
    using namespace lambent::test;
    if (argc != 2)
        return 2;
    const std::filesystem::path folder = argv[1];
    const Pixels pixels = mixed_pixels(12, 1);
    const Bytes two_rows = radiance_header("-Y 2 +X 12", "EXPOSURE=2\n");
    const Bytes seeds[] = {
        two_rows + flat_scanline(pixels) + flat_scanline(pixels),
        two_rows + repeat_scanline(pixels) + flat_scanline(pixels),
        two_rows + plane_scanline(pixels) + plane_scanline(pixels),
        radiance_header("+X 2 -Y 12", "COLORCORR=1 2 3\n") + plane_scanline(pixels) + repeat_scanline(pixels),
    };
    std::ofstream list(folder / "list");
    for (std::size_t i = 0; i < std::size(seeds); ++i) {
        const std::filesystem::path path = folder / std::to_string(i);
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(seeds[i].data()),
                   static_cast<std::streamsize>(seeds[i].size()));
        list << (i > 0 ? "," : "") << path.string();
    }
    return list.good() ? 0 : 1;
}
