#include "environment/panorama/mend_texels.h"

#include "base/text.h"

#include <algorithm>
#include <cmath>

namespace lambent::environment {
namespace {

// Texels filled from the rim of a patch inwards, at most; the middle of a patch wider than twice this stays black.
constexpr int most_layers = 16;

bool sound(float v)
{
    return std::isfinite(v) && v <= brightest_valid;
}

// A panorama's texels by their index, packed or not.
struct PackedTexels {
    Panorama& panorama;

    int width() const { return panorama.width; }
    int height() const { return panorama.height; }
    Rgb get(std::size_t i) const { return unpack_rgb9e5(panorama.texels[i]); }
    void set(std::size_t i, const Rgb& c) const { panorama.texels[i] = pack_rgb9e5(c.r, c.g, c.b); }
};

struct FloatTexels {
    image::RadianceImage& image;

    int width() const { return image.width; }
    int height() const { return image.height; }
    Rgb get(std::size_t i) const
    {
        return {image.values[3 * i], image.values[3 * i + 1], image.values[3 * i + 2]};
    }
    void set(std::size_t i, const Rgb& c) const
    {
        image.values[3 * i] = c.r, image.values[3 * i + 1] = c.g, image.values[3 * i + 2] = c.b;
    }
};

// Finds the mean of the neighbours that are not waiting to be filled; returns false if there are none.
template <class Texels>
bool neighbour_mean(const Texels& panorama, const std::vector<bool>& waiting, std::size_t texel, Rgb& mean)
{
    const int width = panorama.width();
    const int x = static_cast<int>(texel % static_cast<std::size_t>(width));
    const int y = static_cast<int>(texel / static_cast<std::size_t>(width));
    Rgb sum;
    float count = 0.0f;
    for (int row = std::max(y - 1, 0); row <= std::min(y + 1, panorama.height() - 1); ++row)
        for (int step = -1; step <= 1; ++step) {
            const int column = (x + step + width) % width;
            const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                      static_cast<std::size_t>(column);
            if (waiting[index])
                continue;
            const Rgb c = panorama.get(index);
            sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b};
            count += 1.0f;
        }
    if (count == 0.0f)
        return false;
    mean = {sum.r / count, sum.g / count, sum.b / count};
    return true;
}

} // namespace

void BrokenTexels::blacken(std::span<float> rgb, std::size_t first_texel)
{
    // Nearly all rows are valid, which one vectorised pass finds.
    bool all_sound = true;
    for (const float v : rgb)
        all_sound &= v >= 0.0f && v <= brightest_valid;
    if (all_sound)
        return;
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
        float* c = rgb.data() + i;
        const bool broken = !sound(c[0]) || !sound(c[1]) || !sound(c[2]);
        if (broken)
            texels_.push_back(first_texel + i / 3);
        else if (c[0] < 0.0f || c[1] < 0.0f || c[2] < 0.0f)
            ++negative_;
        for (int k = 0; k < 3; ++k)
            c[k] = broken ? 0.0f : std::max(c[k], 0.0f);
    }
}

template <class Texels>
void BrokenTexels::mend_texels(Texels& panorama, const std::string& name, Warnings& warnings) const
{
    const std::size_t count =
        static_cast<std::size_t>(panorama.width()) * static_cast<std::size_t>(panorama.height());
    if (negative_ > 0)
        warnings.push_back(
            text(name, ": ", negative_, " texels with negative light; the negative part is taken as 0"));
    if (texels_.empty())
        return;
    std::vector<bool> waiting(count, false);
    for (const std::size_t texel : texels_)
        waiting[texel] = true;
    std::vector<std::size_t> left = texels_;
    for (int layer = 0; layer < most_layers && !left.empty(); ++layer) {
        std::vector<std::pair<std::size_t, Rgb>> filled;
        std::vector<std::size_t> still;
        for (const std::size_t texel : left) {
            Rgb mean;
            if (neighbour_mean(panorama, waiting, texel, mean))
                filled.emplace_back(texel, mean);
            else
                still.push_back(texel);
        }
        if (filled.empty())
            break;
        for (const auto& [texel, c] : filled) {
            panorama.set(texel, c);
            waiting[texel] = false;
        }
        left = std::move(still);
    }
    warnings.push_back(text(name, ": ", texels_.size(), " of ", count, " texels are not finite or above ",
                            brightest_valid, "; each is replaced by the mean of its neighbours"));
}

void BrokenTexels::mend(Panorama& panorama, const std::string& name, Warnings& warnings) const
{
    PackedTexels texels{panorama};
    mend_texels(texels, name, warnings);
}

void BrokenTexels::mend(image::RadianceImage& panorama, const std::string& name, Warnings& warnings) const
{
    FloatTexels texels{panorama};
    mend_texels(texels, name, warnings);
}

} // namespace lambent::environment
