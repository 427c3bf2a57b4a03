// Pictures that the image benchmarks read and write.
#pragma once

#include "image/image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace lambent::bench {

/// A sky: smooth from horizon to zenith with a sun some ten thousand times brighter, soft clouds and a little
/// sensor noise, as captured panoramas have.
inline image::RadianceImage sky(int width, int height, float noise)
{
    image::RadianceImage result{width, height, 3, {}};
    result.values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    std::minstd_rand random(1);
    std::uniform_real_distribution<float> jitter(1.0f - noise, 1.0f + noise);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(width) * 6.2832f;
            const float v = static_cast<float>(y) / static_cast<float>(height);
            const float cloud =
                0.5f + 0.25f * std::sin(3 * u + 9 * v) * std::sin(20 * v) + 0.1f * std::sin(17 * u);
            const float sun = 20000 * std::exp(-4000 * ((u - 2) * (u - 2) + (v - 0.3f) * (v - 0.3f)));
            float* const pixel = result.pixel(x, y);
            pixel[0] = (0.2f + 0.5f * v + 0.3f * cloud + sun) * jitter(random);
            pixel[1] = (0.4f + 0.4f * v + 0.3f * cloud + sun) * jitter(random);
            pixel[2] = (1.0f - 0.2f * v + 0.3f * cloud + sun * 0.8f) * jitter(random);
        }
    return result;
}

/// Values that no encoding can shorten.
inline image::RadianceImage noise(int width, int height)
{
    image::RadianceImage result{width, height, 3, {}};
    result.values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    std::minstd_rand random(2);
    std::uniform_real_distribution<float> exponent(-20.0f, 20.0f);
    for (float& value : result.values)
        value = std::exp2(exponent(random));
    return result;
}

/// Code values as a render has them: six lit balls with highlights before a gradient, a chequered floor,
/// and grain of up to `grain` codes.
inline image::CodeImage rendered(int width, int height, float grain)
{
    image::CodeImage result{width, height, 3, 8, {}};
    std::minstd_rand random(3);
    std::uniform_real_distribution<float> jitter(-grain, grain);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(width);
            const float v = static_cast<float>(y) / static_cast<float>(height);
            float light = 0.3f + 0.5f * v + 0.1f * std::sin(5 * u), shine = 0.0f;
            if (v > 0.85f)
                light = (static_cast<int>(u * 40) + static_cast<int>(v * 24)) % 2 == 0 ? 0.7f : 0.25f;
            for (int ball = 0; ball < 6; ++ball) {
                const float dx = (u - 0.15f - 0.14f * static_cast<float>(ball)) * 16 / 9 / 0.12f;
                const float dy = (v - 0.5f) / 0.12f;
                const float inside = 1 - dx * dx - dy * dy;
                if (inside > 0) {
                    light = 0.1f + 0.6f * std::sqrt(inside) * (1 - 0.4f * dx);
                    shine = std::pow(std::max(0.0f, std::sqrt(inside) - 0.1f * dx), 30.0f);
                }
            }
            for (const float tint : {1.0f, 0.8f, 0.6f}) {
                const float code = (light * tint + shine) * 255 + 0.5f + jitter(random);
                result.bytes.push_back(static_cast<std::uint8_t>(std::clamp(code, 0.0f, 255.0f)));
            }
        }
    return result;
}

} // namespace lambent::bench
