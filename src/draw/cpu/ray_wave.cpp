#include "draw/cpu/ray_wave.h"

#include "draw/light/random_points.h"
#include "draw/reach.h"

#include <algorithm>

namespace lambent::draw {
namespace {

// A ray that has passed through this many surfaces meets nothing.
constexpr int most_passed = 256;

std::size_t aligned(std::size_t count)
{
    constexpr std::size_t step = Fragments::group_alignment;
    return (count + step - 1) / step * step;
}

void place_ray(const WaveRay& ray, float side, std::size_t at, Fragments& f)
{
    for (int axis = 0; axis < 3; ++axis) {
        f[met_from + axis][at] = ray.origin[axis];
        f[met_along + axis][at] = ray.direction[axis];
    }
    f[met_spread][at] = ray.spread;
    f[hit_distance][at] = ray.hit.distance;
    f[hit_u][at] = ray.hit.u;
    f[hit_v][at] = ray.hit.v;
    f[extent][at] = side;
    f.triangle[at] = ray.hit.triangle;
}

} // namespace

void RayWave::trace(const std::vector<WaveRay*>& rays, bool parallel)
{
    if (!parallel) {
        for (WaveRay* ray : rays)
            ray->hit =
                picture_.scene.visibility().nearest({ray->origin, ray->direction, ray->near, ray->far});
        return;
    }
    packet_.resize(rays.size());
    hits_.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            packet_.origin[axis][i] = rays[i]->origin[axis];
            packet_.direction[axis][i] = rays[i]->direction[axis];
        }
        packet_.near[i] = rays[i]->near;
    }
    packet_.far = 0.0f;
    for (const WaveRay* ray : rays)
        packet_.far = std::max(packet_.far, ray->far);
    picture_.scene.visibility().trace(packet_, hits_.data());
    for (std::size_t i = 0; i < rays.size(); ++i)
        rays[i]->hit = hits_[i].distance > rays[i]->far ? Hit() : hits_[i];
}

// Keeps in `rays` those that pass through the surface that they met, moved behind it.
std::size_t RayWave::pass(std::vector<WaveRay*>& rays)
{
    veiled_.clear();
    std::size_t left = 0, veiled = 0;
    std::vector<WaveRay*> behind_veils;
    for (WaveRay* ray : rays) {
        if (!ray->hit.found())
            continue;
        if (ray->skips_backs && !ray->hit.front && picture_.scene.culls_back(ray->hit.instance))
            rays[left++] = ray;
        else if (picture_.scene.surface(ray->hit.instance).material->alpha_mode != scene::AlphaMode::opaque) {
            veiled_.push_back(*ray);
            behind_veils.push_back(ray);
        }
    }
    if (!veiled_.empty()) {
        place(veiled_, 0.0f, veils_);
        find_groups(veils_);
        for (const Fragments::Group& group : veils_.groups)
            for (std::size_t at = group.begin; at < group.end; ++at) {
                if (veils_.weight[at] <= 0.0f)
                    continue;
                WaveRay* const ray = behind_veils[veils_.pixel[at]];
                ray->seed = hashed(ray->seed, 1u);
                const scene::Material& material = *picture_.scene.surface(group.instance).material;
                if (!(unit_interval(ray->seed) < shown(material, veils_[column_opacity][at])))
                    rays[left + veiled++] = ray;
            }
    }
    rays.resize(left + veiled);
    for (WaveRay* ray : rays)
        ray->near = behind(ray->hit.distance);
    return rays.size();
}

void RayWave::cast(std::vector<WaveRay>& rays, bool parallel)
{
    waiting_.clear();
    for (WaveRay& ray : rays)
        waiting_.push_back(&ray);
    for (int round = 0; round < most_passed && !waiting_.empty(); ++round) {
        trace(waiting_, parallel);
        if (pass(waiting_) == 0)
            return;
    }
    for (WaveRay* ray : waiting_)
        ray->hit = {};
}

void RayWave::block(std::vector<WaveRay>& rays, std::vector<std::uint8_t>& blocked)
{
    blocked.resize(rays.size());
    if (picture_.all_opaque) {
        for (std::size_t i = 0; i < rays.size(); ++i)
            blocked[i] = picture_.scene.visibility().is_blocked(
                {rays[i].origin, rays[i].direction, rays[i].near, rays[i].far});
        return;
    }
    cast(rays, false);
    for (std::size_t i = 0; i < rays.size(); ++i)
        blocked[i] = rays[i].hit.found();
}

// Makes a group for each instance that rays met, with room for its fragments.
void RayWave::make_groups(std::span<const WaveRay> rays, Fragments& fragments)
{
    auto& groups = fragments.groups;
    groups.clear();
    for (const WaveRay& ray : rays) {
        if (!ray.hit.found())
            continue;
        std::uint32_t& group = group_at_[ray.hit.instance];
        if (group == no_group) {
            group = static_cast<std::uint32_t>(groups.size());
            groups.push_back({ray.hit.instance, false, 0, 0});
        }
        ++groups[group].end;
    }
    std::size_t total = 0;
    for (Fragments::Group& group : groups) {
        const std::size_t filled = aligned(group.end);
        group.begin = group.end = total;
        total += filled;
    }
    fragments.resize(total);
}

// Stores the rays that met a surface in their groups. The last fragments of a group, of weight 0, fill its vector.
void RayWave::place(std::span<const WaveRay> rays, float side, Fragments& fragments)
{
    make_groups(rays, fragments);
    const auto add = [&](std::size_t i, float weight) {
        const std::size_t at = fragments.groups[group_at_[rays[i].hit.instance]].end++;
        place_ray(rays[i], side, at, fragments);
        fragments.pixel[at] = static_cast<std::uint32_t>(i);
        fragments.weight[at] = weight;
    };
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (rays[i].hit.found())
            add(i, 1.0f);
    for (const Fragments::Group& group : fragments.groups)
        while (group.end % Fragments::group_alignment != 0)
            add(fragments.pixel[group.end - 1], 0.0f);
    for (const Fragments::Group& group : fragments.groups)
        group_at_[group.instance] = no_group;
}

void RayWave::find_groups(Fragments& fragments)
{
    for (const Fragments::Group& group : fragments.groups) {
        SurfaceContext context = picture_.surface(group.instance);
        context.met_by_rays = true;
        find_surfaces(context, group.begin, group.end, fragments);
    }
}

void RayWave::find(std::span<const WaveRay> rays, float side)
{
    rays_ = rays;
    place(rays, side, fragments_);
    find_groups(fragments_);
}

} // namespace lambent::draw
