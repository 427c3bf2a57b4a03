// Random numbers, vectors and colours, the same everywhere: distributions of the standard library differ.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <random>

namespace lambent::testing {

class RandomNumbers {
public:
    explicit RandomNumbers(std::uint32_t seed) : engine_(seed) { engine_.discard(8); }

    /// From low to high, high excluded.
    float from(float low, float high)
    {
        return low + (high - low) * static_cast<float>(engine_() >> 8) * 0x1p-24f;
    }
    /// 0 to count - 1.
    int below(int count) { return static_cast<int>(from(0.0f, static_cast<float>(count))); }
    bool chance(float probability) { return from(0.0f, 1.0f) < probability; }

    glm::vec3 in_box(const glm::vec3& half)
    {
        const float x = from(-half.x, half.x), y = from(-half.y, half.y), z = from(-half.z, half.z);
        return {x, y, z};
    }
    /// Uniform over the sphere.
    glm::vec3 direction()
    {
        const float z = from(-1.0f, 1.0f), turn = from(0.0f, 6.2831853f), ring = std::sqrt(1.0f - z * z);
        return {ring * std::cos(turn), ring * std::sin(turn), z};
    }
    glm::vec3 color(float low, float high)
    {
        const float r = from(low, high), g = from(low, high), b = from(low, high);
        return {r, g, b};
    }

private:
    std::mt19937 engine_;
};

} // namespace lambent::testing
