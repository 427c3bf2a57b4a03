// Texels of cubes are the nearest halfs, on every processor.
#include "environment/chain/kernels.h"
#include "tests/support/each_instruction_set.h"

#include "environment/panorama/packed_texel.h"

#include <cmath>

namespace lambent::environment {
namespace {

class Halfs : public test::EachInstructionSet {};

// A panorama of one colour, times a factor that no half holds: by the definition of binary16, steps are 2^-10 of the power
// of two below, and 2^-24 from 2^-14 down. [IEEE 754-2019, 3.6]
TEST_P(Halfs, AreTheNearest)
{
    Panorama panorama;
    panorama.width = 8, panorama.height = 4;
    panorama.texels.assign(32, pack_rgb9e5(1.0f, 0.5f, 0x1p-7f));
    CubeChain chain;
    chain.allocate(2, 1);
    const std::vector<TexelPoint> middle = {{0.5f, 0.5f}};
    double sum = 0.0;
    int count = 0;
    for (float factor = 1e-7f; factor < 60000.0f; factor *= 1.0173f) {
        panorama.scale = factor;
        resample_row({&panorama, 1e30f, &middle, 0, 1, 0, 4}, chain);
        const std::uint16_t* const halfs = chain.halfs() + 3 * chain.texel(0, 0, 0, 1);
        const double colors[3] = {factor, 0.5 * factor, 0x1p-7 * factor};
        for (int i = 0; i < 12; ++i) {
            const double exact = colors[i % 3];
            const double step = std::ldexp(1.0, std::max(std::ilogb(exact), -14) - 10);
            const double error = (static_cast<double>(from_half(halfs[i])) - exact) / step;
            ASSERT_LE(std::fabs(error), 0.5 + 1e-3) << exact << " in lane " << i / 3;
            sum += error, ++count;
        }
    }
    EXPECT_NEAR(sum / count, 0.0, 0.02); // neither up nor down
}

LAMBENT_EACH_INSTRUCTION_SET(Halfs);

} // namespace
} // namespace lambent::environment
