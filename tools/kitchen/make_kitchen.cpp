// make_kitchen OUT.exr [--size WxH] [--time S] [--samples N] [--preview OUT.png]
// Writes the file of the built-in environment `kitchen`.
#include "kitchen/trace_kitchen.h"
#include "base/error.h"
#include "base/file.h"
#include "display/display.h"
#include "image/files/image_io.h"
#include "image/luminance.h"
#include "image/openexr/openexr.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

using namespace lambent;

// Compression loss that keeps the file below 1.5 MB.
constexpr float loss = 130.0f;

struct Arguments {
    std::string file, preview;
    KitchenTrace trace;
};

[[noreturn]] void refuse(const std::string& what)
{
    throw Error(Failure::usage,
                what + ": make_kitchen OUT.exr [--size WxH] [--time S] [--samples N] [--preview OUT.png]");
}

Arguments parse(int count, char** words)
{
    Arguments arguments;
    for (int i = 1; i < count; ++i) {
        const std::string_view word = words[i];
        if (word.substr(0, 2) != "--") {
            arguments.file = word;
            continue;
        }
        if (++i == count)
            refuse(std::string(word) + ": value missing");
        KitchenTrace& trace = arguments.trace;
        char rest = 0;
        bool good = true;
        if (word == "--size")
            good = std::sscanf(words[i], "%dx%d%c", &trace.width, &trace.height, &rest) == 2;
        else if (word == "--time")
            good = std::sscanf(words[i], "%lf%c", &trace.seconds, &rest) == 1;
        else if (word == "--samples")
            good = std::sscanf(words[i], "%d%c", &trace.samples, &rest) == 1;
        else if (word == "--preview")
            arguments.preview = words[i];
        else
            refuse(std::string(word) + ": unknown option");
        if (!good || trace.width < 2 || trace.width > 8192 || trace.height < 1 || trace.height > 4096 ||
            !(trace.seconds > 0.0) || trace.samples < 1)
            refuse(std::string(word) + " " + words[i] + ": not a value for it");
    }
    if (arguments.file.empty())
        refuse("no file named");
    return arguments;
}

// The mean radiance over the sphere, which tells how bright an object in the middle of the room looks.
double mean_radiance(const image::RadianceImage& panorama)
{
    double sum = 0.0, weight = 0.0;
    for (int y = 0; y < panorama.height; ++y) {
        const double ring = std::sin((y + 0.5) / panorama.height * 3.14159265358979);
        for (int x = 0; x < panorama.width; ++x) {
            sum += ring * image::luminance(panorama.pixel(x, y));
            weight += ring;
        }
    }
    return sum / weight;
}

void run(const Arguments& arguments)
{
    check_can_write(arguments.file);
    int shown = -1;
    const KitchenPicture picture = trace_kitchen(arguments.trace, [&](double done) {
        const int percent = static_cast<int>(100.0 * done);
        if (percent / 5 != shown / 5)
            std::fprintf(stderr, "%d%%\n", shown = percent);
    });
    std::printf("sky: %.1f samples, noise %.4f; sun: %.1f samples, noise %.4f; mean radiance %.3f\n",
                picture.sky_samples, picture.sky_noise, picture.sun_samples, picture.sun_noise,
                mean_radiance(picture.radiance));
    const std::vector<std::uint8_t> bytes = image::encode_small_exr(picture.radiance, loss);
    write_file(arguments.file, bytes);
    std::printf("%s: %zu bytes\n", arguments.file.c_str(), bytes.size());
    if (!arguments.preview.empty()) {
        display::Settings look;
        look.tone = display::Tone::neutral;
        image::write_codes(display::to_codes(picture.radiance, look), arguments.preview);
    }
}

} // namespace

int main(int count, char** words)
{
    try {
        run(parse(count, words));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_kitchen: error: %s\n", error.what());
        return 1;
    }
}
