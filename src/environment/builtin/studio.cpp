#include "environment/builtin/studio.h"

#include "environment/builtin/softbox.h"
#include "equations/in_double.h"

#include <glm/common.hpp>
#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace lambent::environment {
namespace {

const glm::vec3 warm(1.0f, 0.92f, 0.82f), neutral(1.0f, 0.98f, 0.95f), cool(0.84f, 0.92f, 1.0f);

std::vector<PlacedSoftbox> softboxes()
{
    std::vector<PlacedSoftbox> boxes;
    // Key.
    boxes.emplace_back(Softbox{{-1.2f, 1.4f, 1.2f}, {0.75f, 0.75f}, 0.1f, 0.04f, 16.0f * warm, 0.5f, 0.0f});
    // Strip.
    boxes.emplace_back(Softbox{{1.9f, 0.55f, 0.5f}, {0.18f, 1.1f}, 0.06f, 0.03f, 12.0f * cool, 0.6f, 0.0f});
    // Overhead bank of three.
    for (const float x : {-0.75f, 0.0f, 0.75f})
        boxes.emplace_back(
            Softbox{{x, 2.2f, -0.6f}, {0.22f, 0.9f}, 0.05f, 0.03f, 10.0f * neutral, 0.7f, 0.0f});
    // Rim.
    boxes.emplace_back(
        Softbox{{1.1f, 1.9f, -1.5f}, {0.4f, 0.55f}, 0.06f, 0.03f, 24.0f * neutral, 0.6f, 0.0f});
    // Fill.
    boxes.emplace_back(Softbox{{1.4f, 0.3f, 1.9f}, {0.8f, 0.7f}, 0.08f, 0.03f, 1.2f * neutral, 0.8f, 0.0f});
    return boxes;
}

glm::vec3 room(const glm::vec3& d)
{
    const float floor = glm::smoothstep(0.25f, -0.6f, d.y);
    const float wall = 0.06f - 0.03f * d.y;
    const float glow = 0.09f * std::exp(-16.0f * (d.y + 0.1f) * (d.y + 0.1f)) * (0.7f - 0.3f * d.z);
    return glm::mix(wall, 0.11f, floor) * glm::vec3(1.0f, 0.99f, 0.975f) +
           glow * glm::vec3(0.96f, 0.98f, 1.0f);
}

} // namespace

image::RadianceImage make_studio(int width)
{
    constexpr float pi = std::numbers::pi_v<float>;
    const int height = width / 2;
    image::RadianceImage panorama = image::black_image(width, height);
    const std::vector<PlacedSoftbox> boxes = softboxes();
    const float texel = pi / static_cast<float>(height);
    tbb::parallel_for(0, height, [&](int y) {
        float* values = panorama.pixel(0, y);
        for (int x = 0; x < width; ++x) {
            const in_double::vec3 unit =
                in_double::direction_from_equirectangular({(x + 0.5) / width, (y + 0.5) / height});
            const glm::vec3 d(unit.x, unit.y, unit.z);
            glm::vec3 light = room(d);
            for (const PlacedSoftbox& box : boxes)
                light = box.over(light, d, texel);
            for (int c = 0; c < 3; ++c)
                *values++ = light[c];
        }
    });
    return panorama;
}

} // namespace lambent::environment
