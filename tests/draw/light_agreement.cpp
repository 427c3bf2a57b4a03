#include "tests/draw/light_agreement.h"

#include "draw/cpu/cpu_renderer.h"
#include "environment/environment.h"
#include "reference/tracer.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace lambent::draw::testing {
namespace {

using lambent::testing::RandomScene;

constexpr int block_side = 6;
constexpr double cut_over_mean = 4.0;

// Grey values of a picture, row by row.
struct Traced {
    std::vector<double> light, variance;
    double covered = 0.0; ///< pixels
};
struct Drawn {
    std::vector<double> light, half_difference; ///< of two pictures with independent noise
};

double grey(const float* rgb)
{
    return (static_cast<double>(rgb[0]) + static_cast<double>(rgb[1]) + static_cast<double>(rgb[2])) / 3.0;
}

Traced trace(const RandomScene& scene, int bounces, const Effort& effort)
{
    reference::Settings settings;
    static_cast<view::Picture&>(settings) = scene.picture;
    settings.bounces = bounces;
    settings.samples = effort.samples;
    settings.seed = effort.seed;
    const reference::Result result =
        reference::trace(scene.scene, scene.dark ? nullptr : &scene.panorama, settings);
    Traced made;
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x) {
            made.light.push_back(grey(result.radiance.pixel(x, y)));
            made.covered += static_cast<double>(result.radiance.pixel(x, y)[3]);
            // Channels share their paths: as if their noise were the same.
            made.variance.push_back(grey(result.variance.pixel(x, y)));
        }
    return made;
}

class Drawer {
public:
    explicit Drawer(const RandomScene& scene) : scene_(scene), renderer_(make_cpu_renderer(scene.scene))
    {
        if (!scene.dark)
            environment_ = environment::make_environment(environment::make_panorama(scene.panorama));
    }

    Drawn draw(int bounces, int passes)
    {
        Settings settings;
        static_cast<view::Picture&>(settings) = scene_.picture;
        settings.bounces = bounces;
        settings.passes = passes;
        const environment::Environment* const light = scene_.dark ? nullptr : &environment_;
        const Frame first = renderer_->draw(light, settings);
        settings.camera.right = -settings.camera.right;
        settings.camera.up = -settings.camera.up;
        const Frame second = renderer_->draw(light, settings);
        Drawn made;
        for (int y = 0; y < settings.height; ++y)
            for (int x = 0; x < settings.width; ++x) {
                const double a = grey(first.radiance.pixel(x, y)),
                             b = grey(second.radiance.pixel(settings.width - 1 - x, settings.height - 1 - y));
                made.light.push_back(0.5 * (a + b));
                made.half_difference.push_back(0.5 * (a - b));
            }
        return made;
    }

private:
    const RandomScene& scene_;
    std::unique_ptr<Renderer> renderer_;
    environment::Environment environment_;
};

// Of the pixels of a block, light cut.
struct Sums {
    double picture = 0.0, half_difference = 0.0, truth = 0.0, variance = 0.0, pixels = 0.0;
    double near_cut = 0.0; ///< what the cut of noisy light is off

    void add(const Sums& s)
    {
        picture += s.picture, half_difference += s.half_difference, truth += s.truth;
        variance += s.variance, pixels += s.pixels, near_cut += s.near_cut;
    }
};

// A pixel. Noise of light far above the cut does not count; near it, the mean of what was cut is less than the cut mean, by
// at most 0.4 of the standard deviation.
Sums pixel_sums(const Drawn& picture, const Traced& truth, std::size_t at, double cut)
{
    const double a = std::min(picture.light[at] + picture.half_difference[at], cut),
                 b = std::min(picture.light[at] - picture.half_difference[at], cut);
    const double deviation = std::sqrt(truth.variance[at]),
                 beyond = (truth.light[at] - cut) / std::max(deviation, 1e-30);
    Sums s;
    s.picture = 0.5 * (a + b), s.half_difference = 0.5 * (a - b);
    s.truth = std::min(truth.light[at], cut);
    s.variance = beyond > 3.0 ? 0.0 : truth.variance[at];
    s.near_cut = std::fabs(beyond) < 3.0 ? 0.4 * deviation : 0.0;
    s.pixels = 1.0;
    return s;
}

// Sums of all blocks; the last element: of the whole picture.
std::vector<Sums> block_sums(const RandomScene& scene, const Drawn& picture, const Traced& truth, double cut)
{
    const int columns = scene.picture.width / block_side, rows = scene.picture.height / block_side;
    std::vector<Sums> sums(static_cast<std::size_t>(columns * rows) + 1);
    for (int y = 0; y < scene.picture.height; ++y)
        for (int x = 0; x < scene.picture.width; ++x) {
            const auto at = static_cast<std::size_t>(y * scene.picture.width + x);
            const int column = std::min(x / block_side, columns - 1),
                      row = std::min(y / block_side, rows - 1);
            const Sums pixel = pixel_sums(picture, truth, at, cut);
            sums[static_cast<std::size_t>(row * columns + column)].add(pixel);
            sums.back().add(pixel);
        }
    return sums;
}

} // namespace

double Block::excess(double deviations) const
{
    return std::fabs(off()) - before - deviations * deviation;
}

Agreement compare_light(const RandomScene& scene, const Effort& effort)
{
    const Traced truth = trace(scene, scene.bounces, effort);
    Agreement made;
    made.covered = truth.covered;
    for (const double light : truth.light)
        made.mean += light / std::max(truth.covered, 1.0);
    if (!(made.mean > 0.0))
        return made;
    Drawer drawer(scene);
    const double cut = cut_over_mean * made.mean;
    const std::vector<Sums> sums = block_sums(scene, drawer.draw(scene.bounces, effort.passes), truth, cut),
                            before = block_sums(scene, drawer.draw(0, 1), trace(scene, 0, effort), cut);
    const std::size_t blocks = sums.size() - 1;
    // Differences of single blocks are few numbers each; together they tell how noisy the drawn picture is.
    double pooled = 0.0;
    for (std::size_t i = 0; i < blocks; ++i)
        pooled += sums[i].half_difference * sums[i].half_difference / static_cast<double>(blocks);
    for (std::size_t i = 0; i <= blocks; ++i) {
        const Sums& s = sums[i];
        const double drawn_variance = std::max(s.half_difference * s.half_difference,
                                               i < blocks ? pooled : pooled * static_cast<double>(blocks));
        const double unit = 1.0 / (s.pixels * made.mean);
        const Block block{s.picture * unit, s.truth * unit,
                          (std::sqrt(s.variance + drawn_variance) + s.near_cut) * unit,
                          std::fabs(before[i].picture - before[i].truth) * unit};
        if (i < blocks)
            made.blocks.push_back(block);
        else
            made.whole = block;
    }
    return made;
}

} // namespace lambent::draw::testing
