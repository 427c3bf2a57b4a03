#include "environment/bake/bake_check.h"

#include "environment/bake/reading_sums.h"
#include "environment/bake/texel_sums.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace lambent::environment {
namespace {

constexpr int checks_per_part = 3; // at random texels, and as many near the brightest

struct Check {
    int face, x, y;
};

Check brightest(const image::CubeMap& cube, int level)
{
    const int size = cube.face_size(level);
    Check at{0, 0, 0};
    float most = -1.0f;
    for (int face = 0; face < 6; ++face) {
        const std::span<const float> light = cube.face(level, face);
        for (std::size_t i = 0; i < light.size(); i += 3)
            if (light[i + 1] > most) {
                most = light[i + 1];
                const int texel = static_cast<int>(i / 3);
                at = {face, texel % size, texel / size};
            }
    }
    return at;
}

// Alternates between a random texel and one near the brightest.
std::vector<Check> choose_checks(const image::CubeMap& cube, int level, std::mt19937& random)
{
    const int size = cube.face_size(level);
    std::uniform_int_distribution<int> faces(0, 5), texels(0, size - 1), near(-size / 16 - 1, size / 16 + 1);
    const Check bright = brightest(cube, level);
    std::vector<Check> checks;
    for (int i = 0; i < checks_per_part; ++i) {
        checks.push_back({faces(random), texels(random), texels(random)});
        checks.push_back({bright.face, std::clamp(bright.x + near(random), 0, size - 1),
                          std::clamp(bright.y + near(random), 0, size - 1)});
    }
    return checks;
}

// The relative RMSE over every second check from `first` on.
double relative_error(const std::vector<TexelSum>& sums, const std::vector<const float*>& found,
                      std::size_t first)
{
    double square = 0.0, mean = 0.0;
    for (std::size_t i = 0; i < checks_per_part; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const TexelSum& sum = sums[first + 2 * i];
            const double off = static_cast<double>(found[first + 2 * i][k]) - sum.rgb[k];
            square += off * off;
            mean += sum.rgb[k];
        }
    constexpr double count = 3.0 * checks_per_part;
    return mean > 0.0 ? std::sqrt(square / count) / (mean / count) : 0.0;
}

} // namespace

Direction texel_direction(const CubeTexel& texel)
{
    return cube_direction(texel.face, (2.0 * texel.x + 1.0) / texel.size - 1.0,
                          (2.0 * texel.y + 1.0) / texel.size - 1.0);
}

std::vector<double> check_levels(const Panorama& panorama, TexelMeaning meaning, const image::CubeMap& cube,
                                 const std::vector<CheckedLevel>& levels)
{
    std::mt19937 random(20140601u + static_cast<unsigned>(levels.size()));
    std::vector<TexelSum> sums;
    std::vector<const float*> found;
    for (std::size_t i = 0; i < levels.size(); ++i)
        for (const Check& c : choose_checks(cube, levels[i].level, random)) {
            const Direction d = texel_direction({c.face, c.x, c.y, cube.face_size(levels[i].level)});
            sums.push_back({d.x, d.y, d.z, levels[i].lobe, {}});
            found.push_back(cube.pixel(levels[i].level, c.face, c.x, c.y));
        }
    if (meaning == TexelMeaning::points)
        sum_texels(panorama, sums);
    else
        sum_reading(panorama, sums);
    std::vector<double> errors;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const std::size_t first = 2 * checks_per_part * i;
        errors.push_back(
            std::max(relative_error(sums, found, first), relative_error(sums, found, first + 1)));
    }
    return errors;
}

} // namespace lambent::environment
