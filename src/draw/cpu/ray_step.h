// One step of light: the rays that leave the surfaces of a wave, and the light that they bring.
#pragma once

#include "draw/light/light_class.h"
#include "draw/cpu/ray_wave.h"

#include <array>
#include <cstdint>
#include <vector>

namespace lambent::draw {

/// Sends rays from fragments: one along a direction of a lobe, one to a lamp of the environment, one to a light of the
/// scene. Reuses its buffers from call to call.
class RayStep {
public:
    explicit RayStep(const PictureContext& picture) : picture_(picture), met_(picture) {}

    /// Chooses the rays of all fragments of `from`, made of `rays`, traces them, and finds the surfaces that stop those
    /// along lobes. `together`: rays that share the environment's light around a point; their blurs cover the sphere
    /// together.
    void send(RayWave& from, const std::vector<WaveRay>& rays, float together);

    /// The rays along lobes, and the surfaces that they met, without light.
    const std::vector<WaveRay>& lobes() const { return lobes_; }
    RayWave& met() { return met_; }
    const RayWave& met() const { return met_; }

    /// Adds up the light of each fragment of `from`, where light[i] is what lobes()[i] brings from a surface.
    void collect(const RayWave& from, const std::vector<glm::vec3>& light,
                 std::vector<RayLight>& found) const;

private:
    void choose(RayWave& from, const std::vector<WaveRay>& rays);
    void make_rays(const RayWave& from, std::size_t at, const WaveRay& before);

    const PictureContext& picture_;
    RayWave met_;
    float together_ = 1.0f;
    std::vector<WaveRay> lobes_, lamps_, lights_; ///< owner: the fragment that they leave
    std::vector<std::uint8_t> lamp_blocked_, light_blocked_;
};

/// Three columns of a fragment.
glm::vec3 three(const Fragments& fragments, int column, std::size_t at);

/// The geometric normal on the side from which a ray came.
glm::vec3 normal_towards(const WaveRay& ray);

} // namespace lambent::draw
