#include "draw/cpu/ray_gatherer.h"

#include "draw/cpu/ray_kernel.h"
#include "draw/cpu/specular_kernel.h"
#include "draw/light/random_points.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace lambent::draw {
namespace {

// Camera rays that are traced together: their fragments fit in a core's cache.
constexpr std::size_t rays_of_wave = 1024;

glm::vec3 sum_of(const std::array<glm::vec3, light_classes>& light)
{
    return light[diffuse_light] + light[glossy_light];
}

glm::vec3 all_of(const RayLight& found)
{
    return found.lights_found + sum_of(found.found);
}

} // namespace

RayGatherer::RayGatherer(const PictureContext& picture, const WorldCache* cache)
    : picture_(picture), cache_(cache), seen_(picture), near_(picture), first_(picture), second_(picture)
{
}

// A camera ray through a random point of a pixel.
void RayGatherer::add_sight(int x, int y, std::uint32_t sample)
{
    const RayMap& map = picture_.prepared.rays;
    WaveRay ray;
    ray.owner = static_cast<std::uint32_t>(y * picture_.settings.width + x);
    ray.sequence = hashed(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
    ray.sample = sample;
    const float across = static_cast<float>(x) + random_number(ray.sequence, sample, 0);
    const float down = static_cast<float>(y) + random_number(ray.sequence, sample, 1);
    ray.origin = map.origin + across * map.origin_dx + down * map.origin_dy;
    const glm::vec3 way = map.direction + across * map.direction_dx + down * map.direction_dy;
    const float length = glm::length(way);
    ray.direction = way / length;
    ray.near = map.near * length;
    ray.far = map.far * length;
    ray.spread = glm::length(map.direction_dx) / length;
    ray.skips_backs = true;
    ray.seed = hashed(ray.sequence, sample);
    sights_.push_back(ray);
}

void RayGatherer::find_seen()
{
    seen_.cast(sights_, true);
    seen_.find(sights_, 0.0f);
}

// Fills the columns of light of a wave's fragments, without shadows.
void RayGatherer::light_unshadowed(RayWave& wave)
{
    Fragments& f = wave.fragments();
    const PreparedPicture& prepared = picture_.prepared;
    for (const Fragments::Group& group : f.groups) {
        for (int c = column_direct; c < columns_of_light_end; ++c)
            std::fill(f[c] + group.begin, f[c] + group.end, 0.0f);
        if (picture_.scene.surface(group.instance).material->unlit)
            continue;
        if (!prepared.lights.empty())
            light_directly(prepared.hit_light, prepared.lights, group.begin, group.end, f);
        if (!prepared.light.environment)
            continue;
        light_ambiently(prepared.hit_light, group.begin, group.end, f);
        light_specularly(prepared.hit_light, group.begin, group.end, f);
    }
}

void RayGatherer::soften_all(RayWave& wave) const
{
    for (const Fragments::Group& group : wave.fragments().groups)
        soften(picture_.settings.model, group.begin, group.end, wave.fragments());
}

std::array<glm::vec3, light_classes> RayGatherer::unshadowed_light(const Fragments& f, std::size_t at) const
{
    return {three(f, column_direct, at) + three(f, column_ambient, at), three(f, column_reflected, at)};
}

CachePoint RayGatherer::point_of(const RayWave& wave, std::size_t at) const
{
    const Fragments& f = wave.fragments();
    const WaveRay& ray = wave.rays()[f.pixel[at]];
    CachePoint point;
    point.position = three(f, column_position, at);
    point.normal = three(f, column_shine, at);
    point.instance = ray.hit.instance;
    point.front = ray.hit.front;
    point.distance = glm::length(point.position - picture_.settings.camera.position);
    return point;
}

// Light that a surface emits along the ray that met it. Culled backs of one-sided surfaces emit nothing.
glm::vec3 RayGatherer::emitted(const RayWave& wave, std::size_t at) const
{
    const Hit& hit = wave.rays()[wave.fragments().pixel[at]].hit;
    const bool culled = !hit.front && picture_.scene.culls_back(hit.instance);
    return culled ? glm::vec3(0.0f) : three(wave.fragments(), column_emissive, at);
}

// Light that each ray of a step brings because the surface that it met emits it.
void RayGatherer::emission_of_hits(const RayStep& step)
{
    const RayWave& met = step.met();
    const Fragments& f = met.fragments();
    light_.assign(step.lobes().size(), glm::vec3(0.0f));
    for (const Fragments::Group& group : f.groups)
        for (std::size_t at = group.begin; at < group.end; ++at)
            if (f.weight[at] > 0.0f)
                light_[f.pixel[at]] = emitted(met, at);
}

// Light that each ray of a step brings from the surface that it met; without a cache, only what that emits.
void RayGatherer::light_of_hits(RayStep& step, const WorldCache* cache)
{
    emission_of_hits(step);
    if (!cache)
        return;
    RayWave& met = step.met();
    light_unshadowed(met);
    const Fragments& f = met.fragments();
    for (const Fragments::Group& group : f.groups)
        for (std::size_t at = group.begin; at < group.end; ++at)
            if (f.weight[at] > 0.0f)
                light_[f.pixel[at]] += sum_of(cache->true_light(point_of(met, at), unshadowed_light(f, at)));
}

// Whether a surface that a ray met is so near that the cache's cells are too wide for its light.
bool RayGatherer::is_near(const RayWave& met, std::size_t at) const
{
    constexpr float near_cells = 2.0f;
    return met.fragments()[hit_distance][at] <
           near_cells * cache_->cells().side_at(point_of(met, at).distance);
}

// Whether it mirrors, as seen along the ray: the cache's cells do not know from where glossy light comes.
bool RayGatherer::mirrors(const RayWave& met, std::size_t at) const
{
    constexpr float widest = 0.25f; // alpha
    const Fragments& f = met.fragments();
    return f[column_alpha][at] < widest && f[column_reflected][at] > 0.0f;
}

// Finds the light of such hits by rays of their own.
void RayGatherer::follow(float together)
{
    const RayWave& met = first_.met();
    further_.clear(), asked_.clear();
    for (const Fragments::Group& group : met.fragments().groups)
        for (std::size_t at = group.begin; at < group.end; ++at)
            if (const bool near = is_near(met, at);
                met.fragments().weight[at] > 0.0f && (near || mirrors(met, at))) {
                further_.push_back(first_.lobes()[met.fragments().pixel[at]]);
                asked_.push_back({at, near});
            }
    if (further_.empty())
        return;
    near_.find(further_, 1.0f);
    soften_all(near_);
    second_.send(near_, further_, together);
    near_light_.swap(light_);
    // The rays are a bounce of their own: with two in all, what they meet is lit by nothing.
    light_of_hits(second_, picture_.settings.bounces > 2 ? cache_ : nullptr);
    second_.collect(near_, light_, found_);
    near_light_.swap(light_);
    const Fragments& f = near_.fragments();
    for (const Fragments::Group& group : f.groups)
        for (std::size_t at = group.begin; at < group.end; ++at) {
            if (f.weight[at] <= 0.0f)
                continue;
            const Asked& asked = asked_[f.pixel[at]];
            light_[met.fragments().pixel[asked.at]] =
                emitted(near_, at) + (asked.near ? all_of(found_[at]) : mirrored(met, asked.at, found_[at]));
        }
}

// Light of a surface that mirrors: its glossy light by a ray. Of the light without shadows, which is known exactly, the share
// that arrives by the cache is a control variate.
glm::vec3 RayGatherer::mirrored(const RayWave& met, std::size_t at, const RayLight& found) const
{
    const std::array<glm::vec3, light_classes> unshadowed = unshadowed_light(met.fragments(), at),
                                               cached = cache_->true_light(point_of(met, at), unshadowed);
    const glm::vec3 &exact = unshadowed[glossy_light], &known = cached[glossy_light];
    const float share =
        std::min((known.r + known.g + known.b) / std::max(exact.r + exact.g + exact.b, 1e-30f), 1.0f);
    const glm::vec3 glossy = found.found[glossy_light] + share * (exact - found.unshadowed[glossy_light]);
    return cached[diffuse_light] + glm::max(glossy, glm::vec3(0.0f));
}

void RayGatherer::gather(const TileArea& area, const Pass& pass, const Frame& frame, LightSums& sums)
{
    // Later passes read the environment less blurred: each blur is an error, which no number of such rays takes away.
    const float together = std::min(4.0f + static_cast<float>(pass.number), 64.0f);
    sights_.clear();
    bool wanted = true;
    for (std::uint32_t i = 0; wanted; ++i) {
        wanted = false;
        for (int y = area.y; y < area.y + area.height; ++y)
            for (int x = area.x; x < area.x + area.width; ++x) {
                if (!sums.has(x, y) || !is_covered(frame, x, y))
                    continue;
                const int column = x - sums.area.x, row = y - sums.area.y;
                if (i >= pass.plan.wanted(column, row))
                    continue;
                wanted = true;
                add_sight(x, y, pass.plan.taken(column, row) + i);
                if (sights_.size() == rays_of_wave)
                    gather_wave(together, sums);
            }
    }
    if (!sights_.empty())
        gather_wave(together, sums);
}

// Ends with no sights.
void RayGatherer::gather_wave(float together, LightSums& sums)
{
    find_seen();
    first_.send(seen_, sights_, together);
    light_of_hits(first_, cache_);
    if (cache_)
        follow(together);
    first_.collect(seen_, light_, found_);
    const Fragments& f = seen_.fragments();
    const auto width = static_cast<std::uint32_t>(picture_.settings.width);
    const auto index_of = [&](const WaveRay& sight) {
        return sums.index(static_cast<int>(sight.owner % width), static_cast<int>(sight.owner / width));
    };
    for (const Fragments::Group& group : f.groups)
        for (std::size_t at = group.begin; at < group.end; ++at) {
            if (f.weight[at] <= 0.0f)
                continue;
            const std::size_t pixel = index_of(sights_[f.pixel[at]]);
            sums.add(pixel, sights_[f.pixel[at]].sample % 2, found_[at]);
            if (!sums.has_lights())
                continue;
            add_to(sums.lights_unshadowed, pixel, found_[at].lights_unshadowed);
            add_to(sums.lights_found, pixel, found_[at].lights_found);
        }
    sights_.clear();
}

void RayGatherer::find_places(const TileArea& area, const Places& wanted, const Frame& frame,
                              std::vector<PlaceSample>& places)
{
    constexpr float together = 32.0f; // many rays leave the places of a cell
    for (std::uint32_t i = 0; i < wanted.samples; ++i) {
        const std::uint32_t sample = first_sample_of_cache + i;
        const auto offset = static_cast<int>(sample) % (wanted.spacing * wanted.spacing);
        sights_.clear();
        for (int y = area.y + offset / wanted.spacing; y < area.y + area.height; y += wanted.spacing)
            for (int x = area.x + offset % wanted.spacing; x < area.x + area.width; x += wanted.spacing)
                if (is_covered(frame, x, y))
                    add_sight(x, y, sample);
        if (sights_.empty())
            continue;
        find_seen();
        first_.send(seen_, sights_, together);
        soften_all(first_.met());
        second_.send(first_.met(), first_.lobes(), together);
        add_places(wanted.further, places);
    }
}

// The surfaces that the first step met, with the light that the second step found but for what surfaces reflect.
void RayGatherer::add_places(bool further, std::vector<PlaceSample>& places)
{
    const RayWave& met = first_.met();
    const Fragments& f = met.fragments();
    emission_of_hits(second_);
    second_.collect(met, light_, found_);
    place_of_.assign(f.size(), 0);
    for (const Fragments::Group& group : f.groups)
        for (std::size_t at = group.begin; at < group.end; ++at) {
            if (f.weight[at] <= 0.0f)
                continue;
            PlaceSample sample;
            sample.place = point_of(met, at);
            sample.light = {found_[at].unshadowed, found_[at].found};
            sample.light.unshadowed[diffuse_light] += found_[at].lights_unshadowed;
            sample.light.found[diffuse_light] += found_[at].lights_found;
            sample.share = {three(f, lobe_diffuse, at), three(f, lobe_glossy, at)};
            place_of_[at] = places.size();
            places.push_back(sample);
        }
    if (further)
        add_further(places);
}

// The surfaces that the second step met, to the places that see them.
void RayGatherer::add_further(std::vector<PlaceSample>& places)
{
    RayWave& met = second_.met();
    light_unshadowed(met);
    const Fragments& f = met.fragments();
    for (const Fragments::Group& group : f.groups)
        for (std::size_t at = group.begin; at < group.end; ++at) {
            if (f.weight[at] <= 0.0f)
                continue;
            PlaceSample& sample = places[place_of_[second_.lobes()[f.pixel[at]].owner]];
            sample.has_further = true;
            sample.further = point_of(met, at);
            sample.further_light = unshadowed_light(f, at);
        }
}

} // namespace lambent::draw
