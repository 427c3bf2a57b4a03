#include "compare/appearance.h"

#include "equations/in_double.h"
#include "image/luminance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace lambent::compare {
namespace {

std::size_t pixel_count(const image::RadianceImage& light)
{
    return static_cast<std::size_t>(light.width) * static_cast<std::size_t>(light.height);
}

bool is_covered(const image::RadianceImage& light, std::size_t pixel)
{
    return light.channels < 4 || light.values[4 * pixel + 3] >= 1.0f;
}

const float* value_of(const image::RadianceImage& light, std::size_t pixel)
{
    return light.values.data() + pixel * static_cast<std::size_t>(light.channels);
}

const std::uint8_t* code_of(const image::CodeImage& codes, std::size_t pixel)
{
    return codes.bytes.data() + pixel * static_cast<std::size_t>(codes.channels);
}

void check_same_size(const image::CodeImage& codes, const image::RadianceImage& light)
{
    if (codes.width != light.width || codes.height != light.height || codes.bits != 8)
        throw std::invalid_argument("codes and light of different size");
}

bool keeps_order(const std::uint8_t* code, const float* value)
{
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            if (value[a] > value[b] && code[a] < code[b])
                return false;
    return true;
}

// A summed-area table: the sums of values over all rectangles from the top left corner. [Crow 1984]
class Summed {
public:
    explicit Summed(const image::RadianceImage& shape)
        : width_(shape.width + 1), height_(shape.height + 1),
          sums_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_))
    {
    }

    void add(int x, int y, double value)
    {
        at(x + 1, y + 1) = value + at(x, y + 1) + at(x + 1, y) - at(x, y);
    }

    double around(int x, int y, int radius)
    {
        const int left = std::max(x - radius, 0), right = std::min(x + radius + 1, width_ - 1);
        const int top = std::max(y - radius, 0), bottom = std::min(y + radius + 1, height_ - 1);
        return at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
    }

private:
    double& at(int x, int y)
    {
        return sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                     static_cast<std::size_t>(x)];
    }

    int width_, height_;
    std::vector<double> sums_;
};

} // namespace

double displayed_luminance(const image::CodeImage& codes)
{
    std::array<double, 256> shown{};
    for (std::size_t code = 0; code < shown.size(); ++code)
        shown[code] = in_double::srgb_decode(static_cast<double>(code) / 255.0);
    double sum = 0.0;
    const std::size_t count = static_cast<std::size_t>(codes.width) * static_cast<std::size_t>(codes.height);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* code = code_of(codes, i);
        sum += image::luminance(shown[code[0]], shown[code[1]], shown[code[2]]);
    }
    return sum / static_cast<double>(count);
}

double mean_saturation(const image::CodeImage& codes, const image::RadianceImage& light)
{
    check_same_size(codes, light);
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixel_count(light); ++i) {
        if (!is_covered(light, i))
            continue;
        const std::uint8_t* code = code_of(codes, i);
        const double high = std::max({code[0], code[1], code[2]}),
                     low = std::min({code[0], code[1], code[2]});
        sum += high > 0.0 ? (high - low) / high : 0.0;
        ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

Look look_of(const image::CodeImage& codes)
{
    const std::size_t pixels = static_cast<std::size_t>(codes.width) * static_cast<std::size_t>(codes.height);
    Look sum{};
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::uint8_t* const code = code_of(codes, i);
        const int most = std::max({code[0], code[1], code[2]}), least = std::min({code[0], code[1], code[2]});
        sum.mean += (code[0] + code[1] + code[2]) / 765.0;
        sum.saturation += most > 0 ? static_cast<double>(most - least) / most : 0.0;
        sum.blank += least >= 250 ? 1.0 : 0.0;
        sum.black += most <= 25 ? 1.0 : 0.0;
    }
    const double share = pixels > 0 ? 1.0 / static_cast<double>(pixels) : 0.0;
    return {share * sum.mean, share * sum.saturation, share * sum.blank, share * sum.black};
}

double code_difference(const image::CodeImage& a, const image::CodeImage& b)
{
    if (a.width != b.width || a.height != b.height || a.bits != 8 || b.bits != 8)
        throw std::invalid_argument("codes of different size");
    const std::size_t pixels = static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height);
    double sum = 0.0;
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            sum += std::pow((code_of(a, i)[c] - code_of(b, i)[c]) / 255.0, 2.0);
    return pixels > 0 ? std::sqrt(sum / (3.0 * static_cast<double>(pixels))) : 0.0;
}

double kept_hue_order(const image::CodeImage& codes, const image::RadianceImage& light)
{
    check_same_size(codes, light);
    std::vector<std::size_t> pixels(pixel_count(light));
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = i;
    const auto brightest =
        pixels.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(1, pixels.size() / 10));
    std::nth_element(pixels.begin(), brightest - 1, pixels.end(), [&](std::size_t a, std::size_t b) {
        return image::luminance(value_of(light, a)) > image::luminance(value_of(light, b));
    });
    const auto kept = std::count_if(pixels.begin(), brightest, [&](std::size_t i) {
        return keeps_order(code_of(codes, i), value_of(light, i));
    });
    return static_cast<double>(kept) / static_cast<double>(brightest - pixels.begin());
}

double luminance_spread(const image::RadianceImage& light)
{
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (std::size_t i = 0; i < pixel_count(light); ++i) {
        if (!is_covered(light, i))
            continue;
        const double value = image::luminance(value_of(light, i));
        sum += value;
        squares += value * value;
        count += 1.0;
    }
    return sum > 0.0 ? std::sqrt(std::max(0.0, squares * count - sum * sum)) / sum : 0.0;
}

double fine_difference(const image::RadianceImage& picture, const image::RadianceImage& limit)
{
    if (picture.width != limit.width || picture.height != limit.height)
        throw std::invalid_argument("pictures of different size");
    constexpr int radius = 8;
    Summed differences(limit), counts(limit);
    const auto pixel_at = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(limit.width) +
               static_cast<std::size_t>(x);
    };
    const auto difference = [&](std::size_t i) {
        return image::luminance(value_of(picture, i)) - image::luminance(value_of(limit, i));
    };
    for (int y = 0; y < limit.height; ++y)
        for (int x = 0; x < limit.width; ++x) {
            const bool counted = is_covered(limit, pixel_at(x, y));
            differences.add(x, y, counted ? difference(pixel_at(x, y)) : 0.0);
            counts.add(x, y, counted ? 1.0 : 0.0);
        }
    double squares = 0.0, light = 0.0, count = 0.0;
    for (int y = 0; y < limit.height; ++y)
        for (int x = 0; x < limit.width; ++x) {
            const std::size_t i = pixel_at(x, y);
            if (!is_covered(limit, i))
                continue;
            const double fine =
                difference(i) - differences.around(x, y, radius) / counts.around(x, y, radius);
            squares += fine * fine;
            light += image::luminance(value_of(limit, i));
            count += 1.0;
        }
    return light > 0.0 ? std::sqrt(squares * count) / light : 0.0;
}

} // namespace lambent::compare
