// Compares pictures with bounces of random scenes with the path tracer's, and prints a line for each scene.
//     random_light FIRST COUNT [PASSES SAMPLES [WIDTH HEIGHT]]
#include "tests/draw/light_agreement.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace lambent;

int number(int count, char** words, int index, int otherwise)
{
    return index < count ? std::atoi(words[index]) : otherwise;
}

void print(std::uint32_t scene_number, const draw::testing::Effort& effort, int width, int height)
{
    const auto begin = std::chrono::steady_clock::now();
    const testing::RandomScene scene = testing::random_scene(scene_number, width, height);
    const draw::testing::Agreement found = draw::testing::compare_light(scene, effort);
    constexpr double deviations = 4.0;
    draw::testing::Block worst;
    for (const draw::testing::Block& block : found.blocks)
        if (block.excess(deviations) > worst.excess(deviations))
            worst = block;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::printf("%u mean %.4g covered %.0f whole %+.4f sd %.4f excess %.4f block %+.4f sd %.4f excess %.4f "
                "bounces %d "
                "time %.2f: %s\n",
                scene_number, found.mean, found.covered, found.whole.off(), found.whole.deviation,
                found.whole.excess(deviations), worst.off(), worst.deviation, worst.excess(deviations),
                scene.bounces, seconds, scene.words.c_str());
    std::fflush(stdout);
}

} // namespace

int main(int count, char** words)
{
    if (count < 3) {
        std::fprintf(stderr, "random_light FIRST COUNT [PASSES SAMPLES [WIDTH HEIGHT]]\n");
        return 2;
    }
    const draw::testing::Effort effort{number(count, words, 3, 16), number(count, words, 4, 256)};
    const int first = number(count, words, 1, 0);
    for (int i = first; i < first + number(count, words, 2, 1); ++i)
        print(static_cast<std::uint32_t>(i), effort, number(count, words, 5, 48),
              number(count, words, 6, 36));
}
