#include "environment/panorama/panorama.h"

#include "base/text.h"
#include "environment/panorama/mend_texels.h"
#include "environment/panorama/pack_row.h"
#include "image/panorama_rows.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

namespace lambent::environment {
namespace {

constexpr float largest_packed = 65408.0f;
constexpr int rows_at_once = 256; // the readers convert in parallel from about this many

// Packs rows as they are read. The scale is doubled when a row needs it, and the rows before are packed again.
class Packer {
public:
    explicit Packer(Panorama& panorama) : panorama_(panorama) {}

    void add(const float* rgb, int first_row, int rows)
    {
        const std::size_t width = static_cast<std::size_t>(panorama_.width);
        fit_scale(largest(rgb, width * static_cast<std::size_t>(rows) * 3), first_row);
        tbb::parallel_for(0, rows, [&](int row) {
            const std::size_t offset = static_cast<std::size_t>(row) * width;
            pack_row(rgb + 3 * offset, panorama_.width, 1.0f / panorama_.scale,
                     panorama_.texels.data() + static_cast<std::size_t>(first_row) * width + offset);
        });
    }

private:
    static float largest(const float* values, std::size_t count)
    {
        using Range = tbb::blocked_range<std::size_t>;
        return tbb::parallel_reduce(
            Range(0, count, 1 << 14), 0.0f,
            [values](const Range& range, float most) {
                for (std::size_t i = range.begin(); i < range.end(); ++i)
                    most = values[i] > most ? values[i] : most;
                return most;
            },
            [](float a, float b) { return a > b ? a : b; });
    }

    void fit_scale(float brightest, int rows_done)
    {
        const float before = panorama_.scale;
        while (brightest > largest_packed * panorama_.scale)
            panorama_.scale *= 2.0f;
        if (panorama_.scale == before)
            return;
        const float factor = before / panorama_.scale;
        const std::size_t done =
            static_cast<std::size_t>(rows_done) * static_cast<std::size_t>(panorama_.width);
        for (std::size_t i = 0; i < done; ++i) {
            const Rgb c = unpack_rgb9e5(panorama_.texels[i]);
            panorama_.texels[i] = pack_rgb9e5(c.r * factor, c.g * factor, c.b * factor);
        }
    }

    Panorama& panorama_;
};

Panorama empty_panorama(int width, int height)
{
    Panorama panorama;
    panorama.width = width;
    panorama.height = height;
    panorama.texels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    return panorama;
}

void check_shape(int width, int height, const std::string& name, Warnings& warnings)
{
    if (width < 2)
        throw Error(Failure::bad_input, text(name, ": ", width, "x", height, " is too small for a panorama"));
    if (width != 2 * height)
        warnings.push_back(text(name, ": ", width, "x", height,
                                " is not twice as wide as high; it is stretched over the whole sphere"));
}

} // namespace

double texel_solid_angle(const Panorama& panorama, int y)
{
    return image::texel_solid_angle(panorama.width, panorama.height, y);
}

Panorama load_panorama(image::RadianceReader& reader, const std::string& name, Warnings& warnings)
{
    const int width = reader.width(), height = reader.height();
    warnings.insert(warnings.end(), reader.warnings().begin(), reader.warnings().end());
    check_shape(width, height, name, warnings);
    Panorama panorama = empty_panorama(width, height);
    Packer packer(panorama);
    BrokenTexels broken;
    std::vector<float> rows(static_cast<std::size_t>(rows_at_once) * static_cast<std::size_t>(width) * 3);
    for (int y = 0; y < height; y += rows_at_once) {
        const int count = std::min(rows_at_once, height - y);
        reader.read_rows(count, rows.data());
        const std::size_t texels = static_cast<std::size_t>(count) * static_cast<std::size_t>(width);
        const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        broken.blacken({rows.data(), 3 * texels}, first);
        packer.add(rows.data(), y, count);
    }
    broken.mend(panorama, name, warnings);
    return panorama;
}

Panorama load_panorama(const std::filesystem::path& path, Warnings& warnings)
{
    return load_panorama(*image::open_panorama(path), path.string(), warnings);
}

image::RadianceImage load_unpacked_panorama(const std::filesystem::path& path, Warnings& warnings)
{
    const std::unique_ptr<image::RadianceReader> reader = image::open_panorama(path);
    warnings.insert(warnings.end(), reader->warnings().begin(), reader->warnings().end());
    image::RadianceImage panorama = image::read_all_rows(*reader);
    check_shape(panorama.width, panorama.height, path.string(), warnings);
    BrokenTexels broken;
    broken.blacken(panorama.values, 0);
    broken.mend(panorama, path.string(), warnings);
    return panorama;
}

Panorama make_panorama(const image::RadianceImage& image)
{
    Panorama panorama = empty_panorama(image.width, image.height);
    Packer packer(panorama);
    std::vector<float> row(static_cast<std::size_t>(image.width) * 3);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x)
            std::copy_n(image.pixel(x, y), 3, row.data() + 3 * static_cast<std::size_t>(x));
        packer.add(row.data(), y, 1);
    }
    return panorama;
}

Panorama halved(const Panorama& panorama)
{
    Panorama half = empty_panorama(panorama.width / 2, panorama.height / 2);
    half.scale = panorama.scale;
    tbb::parallel_for(0, half.height, [&](int y) {
        const double above = texel_solid_angle(panorama, 2 * y),
                     below = texel_solid_angle(panorama, 2 * y + 1);
        const float upper = static_cast<float>(above / (above + below) / 2.0), lower = 0.5f - upper;
        const std::size_t width = static_cast<std::size_t>(panorama.width);
        const std::uint32_t* first = panorama.texels.data() + 2 * static_cast<std::size_t>(y) * width;
        const std::uint32_t* second = first + width;
        for (std::size_t x = 0; x < width / 2; ++x) {
            const Rgb a = unpack_rgb9e5(first[2 * x]), b = unpack_rgb9e5(first[2 * x + 1]);
            const Rgb c = unpack_rgb9e5(second[2 * x]), d = unpack_rgb9e5(second[2 * x + 1]);
            half.texels[static_cast<std::size_t>(y) * (width / 2) + x] = pack_rgb9e5(
                upper * (a.r + b.r) + lower * (c.r + d.r), upper * (a.g + b.g) + lower * (c.g + d.g),
                upper * (a.b + b.b) + lower * (c.b + d.b));
        }
    });
    return half;
}

} // namespace lambent::environment
