#include "draw/cpu/ray_step.h"

#include "draw/light/random_points.h"
#include "draw/cpu/ray_kernel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace lambent::draw {
namespace {

// Dimensions of random_number: the place in the pixel, then those of the columns from random_lobe on.
constexpr std::size_t first_of_rays = 2;
constexpr int random_columns = lobe_way - random_lobe;

// Origin of rays that leave a surface point, offset so that they do not meet the point's own triangle: floats of its
// position are exact to 2^-24.
glm::vec3 start_beside(const glm::vec3& position, const glm::vec3& towards)
{
    const glm::vec3 size = glm::abs(position);
    return position + (std::max({size.x, size.y, size.z}) * 0x1p-19f + 1e-30f) * towards;
}

// The width of a box with the variance of the part of the sphere that a ray stands for.
float spread_of(float density, float rays)
{
    const float variance = 0.0796f / (rays * density);
    return std::min(std::sqrt(12.0f * variance), 1.0f);
}

bool is_dark(const Fragments& f, int light, std::size_t at)
{
    for (int c = 0; c < 6; ++c)
        if (f[light + c][at] > 0.0f)
            return false;
    return true;
}

} // namespace

glm::vec3 three(const Fragments& f, int column, std::size_t at)
{
    return {f[column][at], f[column + 1][at], f[column + 2][at]};
}

glm::vec3 normal_towards(const WaveRay& ray)
{
    return ray.hit.front ? ray.hit.normal : -ray.hit.normal;
}

void RayStep::choose(RayWave& from, const std::vector<WaveRay>& rays)
{
    Fragments& f = from.fragments();
    const RayChoice choice{picture_.prepared.lights, together_};
    for (const Fragments::Group& group : f.groups) {
        for (std::size_t at = group.begin; at < group.end; ++at)
            for (int i = 0; i < random_columns; ++i)
                f[random_lobe + i][at] = random_number(rays[f.pixel[at]].sequence, rays[f.pixel[at]].sample,
                                                       first_of_rays + static_cast<std::size_t>(i));
        choose_rays(picture_.prepared.light, choice, group.begin, group.end, f);
    }
}

// Makes the rays that leave one fragment. Those below its triangle would start inside the surface.
void RayStep::make_rays(const RayWave& from, std::size_t at, const WaveRay& before)
{
    const Fragments& f = from.fragments();
    const glm::vec3 normal = normal_towards(before);
    WaveRay ray;
    ray.owner = static_cast<std::uint32_t>(at);
    ray.origin = start_beside(three(f, column_position, at), normal);
    ray.seed = hashed(before.seed, 2u);
    ray.sequence = hashed(before.sequence, 3u);
    ray.sample = before.sample;
    const auto add = [&](int way, std::vector<WaveRay>& rays) {
        ray.direction = three(f, way, at);
        if (glm::dot(normal, ray.direction) > 0.0f)
            rays.push_back(ray);
    };
    if (!is_dark(f, lamp_diffuse, at))
        add(lamp_way, lamps_);
    if (const float density = f[lobe_density][at]; density > 0.0f && !is_dark(f, lobe_diffuse, at)) {
        ray.spread = spread_of(density, together_);
        add(lobe_way, lobes_);
    }
    if (const float distance = f[light_distance][at]; distance > 0.0f) {
        ray.far = distance * (1.0f - 1e-4f);
        add(light_way, lights_);
    }
}

void RayStep::send(RayWave& from, const std::vector<WaveRay>& rays, float together)
{
    together_ = together;
    choose(from, rays);
    const Fragments& f = from.fragments();
    lobes_.clear(), lamps_.clear(), lights_.clear();
    for (const Fragments::Group& group : f.groups) {
        if (picture_.scene.surface(group.instance).material->unlit)
            continue;
        for (std::size_t at = group.begin; at < group.end; ++at)
            if (f.weight[at] > 0.0f)
                make_rays(from, at, rays[f.pixel[at]]);
    }
    met_.cast(lobes_, false);
    met_.block(lamps_, lamp_blocked_);
    met_.block(lights_, light_blocked_);
    met_.find(lobes_, 1.0f);
}

void RayStep::collect(const RayWave& from, const std::vector<glm::vec3>& light,
                      std::vector<RayLight>& found) const
{
    constexpr int lobe_share[] = {lobe_diffuse, lobe_glossy}, lamp_light[] = {lamp_diffuse, lamp_glossy};
    const Fragments& f = from.fragments();
    found.assign(f.size(), {});
    for (const Fragments::Group& group : f.groups) {
        if (picture_.scene.surface(group.instance).material->unlit)
            continue;
        for (std::size_t at = group.begin; at < group.end; ++at) {
            const glm::vec3 radiance = three(f, lobe_radiance, at);
            for (std::size_t k = 0; k < light_classes; ++k)
                found[at].unshadowed[k] =
                    three(f, lobe_share[k], at) * radiance + three(f, lamp_light[k], at);
            found[at].lights_unshadowed = three(f, light_diffuse, at) + three(f, light_glossy, at);
        }
    }
    for (std::size_t i = 0; i < lobes_.size(); ++i) {
        const std::size_t at = lobes_[i].owner;
        const glm::vec3 arriving = lobes_[i].hit.found() ? light[i] : three(f, lobe_radiance, at);
        for (std::size_t k = 0; k < light_classes; ++k)
            found[at].found[k] += three(f, lobe_share[k], at) * arriving;
    }
    for (std::size_t i = 0; i < lamps_.size(); ++i)
        for (std::size_t k = 0; k < light_classes && !lamp_blocked_[i]; ++k)
            found[lamps_[i].owner].found[k] += three(f, lamp_light[k], lamps_[i].owner);
    for (std::size_t i = 0; i < lights_.size(); ++i)
        if (!light_blocked_[i])
            found[lights_[i].owner].lights_found = found[lights_[i].owner].lights_unshadowed;
}

} // namespace lambent::draw
