// How fast a Radiance panorama comes into memory, beside stb_image and beside plain copying.
#include "bench/image/test_pictures.h"
#include "bench/side_by_side.h"
#include "base/file.h"
#include "image/files/image_io.h"
#include "image/radiance/rgbe.h"

#include <stb/stb_image.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace {

using lambent::image::RadianceImage;

constexpr int width = 4096;
constexpr int height = 2048;
constexpr std::size_t floats = std::size_t{width} * height * 3;

// The variant without any run length coding, which the library never writes.
void write_flat(const RadianceImage& picture, const std::filesystem::path& path)
{
    std::ofstream out(path, std::ios::binary);
    out << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " << height << " +X " << width << "\n";
    for (std::size_t i = 0; i < floats; i += 3) {
        const float* const p = picture.values.data() + i;
        const lambent::image::Rgbe codes = lambent::image::to_rgbe(p[0], p[1], p[2]);
        out.write(reinterpret_cast<const char*>(codes.data()), 4);
    }
}

// Into fresh memory, as a reader gets it.
void copy_as_much()
{
    static const std::vector<float> from(floats, 1.0f);
    const std::unique_ptr<float[]> to(new float[floats]);
    std::memcpy(to.get(), from.data(), floats * sizeof(float));
    volatile float sink = to[floats / 2];
    (void)sink;
}

void compare_readers(const char* content, const std::filesystem::path& path)
{
    const auto ours = [&] { (void)lambent::image::read_radiance(path); };
    const auto ours_by_rows = [&] {
        constexpr int rows = 128;
        static std::vector<float> band(std::size_t{rows} * width * 3);
        const auto reader = lambent::image::open_radiance(path);
        for (int y = 0; y < height; y += rows)
            reader->read_rows(rows, band.data());
    };
    const auto theirs = [&] {
        int w = 0, h = 0, channels = 0;
        stbi_image_free(stbi_loadf(path.c_str(), &w, &h, &channels, 3));
    };
    const std::string label =
        std::string(content) + ", " + std::to_string(std::filesystem::file_size(path) >> 20) + " MB: ";
    constexpr int rounds = 9;
    const double bytes = static_cast<double>(floats * sizeof(float));
    const auto whole = lambent::bench::side_by_side(label + "whole, against stb_image", rounds, ours, theirs);
    lambent::bench::side_by_side(label + "by rows, against stb_image", rounds, ours_by_rows, theirs);
    const auto copy =
        lambent::bench::side_by_side(label + "whole, against memcpy", rounds, ours, copy_as_much);
    std::printf("    floats made: %.2f GB/s; stb_image %.2f GB/s; memcpy into fresh memory %.2f GB/s\n",
                bytes / whole.ours * 1e-9, bytes / whole.other * 1e-9, bytes / copy.other * 1e-9);
}

} // namespace

int main()
{
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("lambent-load-hdr-" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    std::printf("Radiance .hdr, %dx%d, into RGB floats (%zu MB)\n", width, height,
                floats * sizeof(float) >> 20);
    const RadianceImage noise = lambent::bench::noise(width, height);
    lambent::image::write_radiance(noise, folder / "noise.hdr");
    lambent::image::write_radiance(lambent::bench::sky(width, height, 0.0f), folder / "smooth.hdr");
    lambent::image::write_radiance(lambent::bench::sky(width, height, 0.02f), folder / "sky.hdr");
    write_flat(noise, folder / "flat.hdr");
    compare_readers("noise", folder / "noise.hdr");
    compare_readers("smooth sky", folder / "smooth.hdr");
    compare_readers("sky with grain", folder / "sky.hdr");
    compare_readers("flat", folder / "flat.hdr");
    std::filesystem::remove_all(folder);
    return 0;
}
