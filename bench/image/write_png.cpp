// Which zlib level, strategy and row filters write a rendered picture well: time and size beside the
// default's.
#include "bench/image/test_pictures.h"
#include "bench/side_by_side.h"
#include "image/codes/png.h"

#include <cstdio>
#include <string>

namespace {

using lambent::image::CodeImage;
using lambent::image::PngEffort;

struct Choice {
    const char* name;
    PngEffort effort;
};

constexpr Choice others[] = {
    {"left, level 1", {1, 0, 16}},
    {"left, level 3", {3, 1, 16}},
    {"left, level 6", {6, 1, 16}},
    {"left, Huffman only", {1, 2, 16}},
    {"above, runs", {1, 3, 32}},
    {"average, runs", {1, 3, 64}},
    {"Paeth, runs", {1, 3, 128}},
    {"left or above by row, runs", {1, 3, 48}},
    {"all five by row, runs", {1, 3, 248}},
    {"all five by row, level 6", {6, 0, 248}},
    {"no filter, level 1", {1, 0, 0}},
};

void compare(const char* content, const CodeImage& picture)
{
    const auto size = [&](const PngEffort& effort) {
        return lambent::image::encode_png(picture, effort).size() >> 10;
    };
    const auto encode = [&](const PngEffort& effort) { (void)lambent::image::encode_png(picture, effort); };
    std::printf("%s: the default (left, runs) makes %zu KB\n", content, size(PngEffort{}));
    for (const Choice& other : others) {
        const std::string label = "  default, against " + std::string(other.name);
        lambent::bench::side_by_side(
            label, 5, [&] { encode({}); }, [&] { encode(other.effort); });
        std::printf("%60s %zu KB\n", "", size(other.effort));
    }
}

} // namespace

int main()
{
    std::printf("PNG, 1280x720, 8-bit RGB\n");
    compare("no grain", lambent::bench::rendered(1280, 720, 0.0f));
    compare("grain of one code", lambent::bench::rendered(1280, 720, 1.0f));
    compare("grain of three codes", lambent::bench::rendered(1280, 720, 3.0f));
    return 0;
}
