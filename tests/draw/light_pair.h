// A picture with bounces and the path tracer's of the same scene.
#pragma once

#include "reference/tracer.h"
#include "tests/draw/test_scenes.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace lambent::draw::testing {

struct LightPair {
    image::RadianceImage picture, truth, variance;

    double mean(const image::RadianceImage& image) const
    {
        double sum = 0.0, pixels = 0.0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                if (!(truth.pixel(x, y)[3] > 0.0f))
                    continue;
                pixels += 3.0;
                for (int c = 0; c < 3; ++c)
                    sum += static_cast<double>(image.pixel(x, y)[c]);
            }
        return sum / std::max(pixels, 1.0);
    }
    double ratio() const { return mean(picture) / mean(truth); }

    /// Relative RMSE over the pixels that surfaces cover and `counts` takes, light cut, without the truth's noise.
    double error(double cut, const std::function<bool(int, int)>& counts = {}) const
    {
        double squares = 0.0, sum = 0.0, pixels = 0.0;
        for (int y = 0; y < truth.height; ++y)
            for (int x = 0; x < truth.width; ++x) {
                if (!(truth.pixel(x, y)[3] > 0.0f) || (counts && !counts(x, y)))
                    continue;
                pixels += 3.0;
                for (int c = 0; c < 3; ++c) {
                    const double a = std::min(static_cast<double>(picture.pixel(x, y)[c]), cut),
                                 b = std::min(static_cast<double>(truth.pixel(x, y)[c]), cut);
                    squares +=
                        (a - b) * (a - b) - (b < cut ? static_cast<double>(variance.pixel(x, y)[c]) : 0.0);
                    sum += b;
                }
            }
        return std::sqrt(std::max(squares, 0.0) * pixels) / sum;
    }
};

/// `panorama` null: no environment.
inline LightPair draw_and_trace(const scene::Scene& scene, const image::RadianceImage* panorama,
                                const Settings& settings, int samples)
{
    reference::Settings asked;
    static_cast<view::Picture&>(asked) = settings;
    asked.bounces = settings.bounces;
    asked.samples = samples;
    reference::Result truth = reference::trace(scene, panorama, asked);
    environment::Environment environment;
    if (panorama)
        environment = environment::make_environment(environment::make_panorama(*panorama));
    Frame frame = draw(scene, panorama ? &environment : nullptr, settings);
    return {std::move(frame.radiance), std::move(truth.radiance), std::move(truth.variance)};
}

} // namespace lambent::draw::testing
