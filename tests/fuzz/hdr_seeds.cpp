// Small valid Radiance pictures for fuzz_hdr to start from: one in each encoding, one in columns.
#include "tests/fuzz/seed_files.h"
#include "tests/image/radiance_writer.h"

int main(int argc, char** argv)
{
    using namespace lambent::test;
    if (argc != 2)
        return 2;
    const Pixels pixels = mixed_pixels(12, 1);
    const Bytes two_rows = radiance_header("-Y 2 +X 12", "EXPOSURE=2\n");
    const Bytes seeds[] = {
        two_rows + flat_scanline(pixels) + flat_scanline(pixels),
        two_rows + repeat_scanline(pixels) + flat_scanline(pixels),
        two_rows + plane_scanline(pixels) + plane_scanline(pixels),
        radiance_header("+X 2 -Y 12", "COLORCORR=1 2 3\n") + plane_scanline(pixels) + repeat_scanline(pixels),
    };
    return lambent::fuzz::write_seeds(argv[1], seeds);
}
