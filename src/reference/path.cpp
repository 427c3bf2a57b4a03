#include "reference/path.h"

#include "image/luminance.h"
#include "reference/light_arrival.h"
#include "reference/obstacles.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace lambent::reference {
namespace {

// After this many bounces paths end at random, and those that continue are weighted accordingly (Russian roulette).
// [Arvo and Kirk 1990]
constexpr int least_bounces = 3;

// If a scene has more lights without size than this, each point is lit by one of them, chosen at random.
constexpr std::size_t most_lights_at_once = 8;

// Candidate directions to the environment for each one that is traced: most bright directions contribute little if the
// surface reflects little of their light. (Of 1, 2, 3 and 4, this reaches equal error fastest; bench_cycles.)
constexpr int most_candidates = 2;

// Weight of a sample whose density is `density` by its own strategy, and `other` by the other strategy.
// [balance heuristic: Veach and Guibas 1995, "Optimally combining sampling techniques for Monte Carlo rendering"]
double weight_of(double density, double other)
{
    return density / (density + other);
}

// Origin of rays that leave a surface point, offset so that they do not meet the point's own triangle: floats of its
// position are exact to 2^-24.
glm::vec3 start_beside(const glm::dvec3& position, const glm::dvec3& towards)
{
    const double size = std::max({std::fabs(position.x), std::fabs(position.y), std::fabs(position.z)});
    return glm::vec3(position + (size * 0x1p-20 + 1e-30) * towards);
}

class Path {
public:
    Path(const World& world, SampleSequence& sampler, FirstSurface* first)
        : world_(world), sampler_(sampler), first_(first)
    {
    }

    Sight follow(const SightRay& sight);

private:
    struct Candidate;
    Candidate candidate(const Surface& surface, const Reflection& reflection, const glm::dvec2& u) const;
    glm::dvec3 light_from(const Surface& surface, const Reflection& reflection, const glm::dvec2& u);
    glm::dvec3 light_from_emitters(const Surface& surface, const Reflection& reflection);
    glm::dvec3 emitted(const trace::Hit& hit, const Surface& surface, int bounce) const;
    glm::dvec3 lamps(const Surface& surface, const Reflection& reflection);
    glm::dvec3 lamp(const scene::Light& light, const Surface& surface, const Reflection& reflection) const;
    glm::dvec3 background(const glm::dvec3& direction);
    glm::dvec3 escaped(const glm::dvec3& direction) const;
    bool survives(int bounce);
    void note_background(const glm::dvec3& radiance);
    void note_surface(const Surface& surface, const glm::dvec3& origin, const glm::dvec3& emission);
    glm::dvec3 scattered(const Surface& surface);
    bool below(const Surface& surface, const glm::dvec3& direction) const;

    const World& world_;
    SampleSequence& sampler_;
    FirstSurface* const first_;  ///< null: not asked for
    glm::dvec3 throughput_{1.0}; ///< of the path so far
    glm::dvec3 next_{0.0};       ///< sampled direction in which the path continues
    double density_ = 0.0;       ///< density of next_; 0: the path ends
    double candidates_ = 1.0;    ///< candidate directions to the environment at the last point
    glm::dvec3 last_{0.0};       ///< position of the last point
};

// Whether a direction is below the triangle, although it may be above the smooth surface. Ignored without shadows.
bool Path::below(const Surface& surface, const glm::dvec3& direction) const
{
    return world_.bounces > 0 && !(glm::dot(surface.geometric, direction) > 0.0);
}

// A direction sampled by the environment's luminance, and the light from it that the surface would reflect if nothing
// blocked it.
struct Path::Candidate {
    glm::dvec3 direction{0.0};
    glm::dvec3 light{0.0};
    double size = 0.0; ///< luminance of light
};

Path::Candidate Path::candidate(const Surface& surface, const Reflection& reflection,
                                const glm::dvec2& u) const
{
    const EnvironmentLight::Drawn drawn = world_.environment->draw(u);
    if (!(drawn.density > 0.0) || below(surface, drawn.direction))
        return {};
    const glm::dvec3 value = reflection.value(drawn.direction);
    if (value == glm::dvec3(0.0))
        return {};
    const bool alone = world_.strategy == Strategy::lights_only;
    const double weight =
        alone ? 1.0 : weight_of(candidates_ * drawn.density, reflection.density(drawn.direction));
    const glm::dvec3 light = (weight / drawn.density) * value * world_.environment->radiance_at(drawn.place);
    return {drawn.direction, light, image::luminance(&light.x)};
}

// Light of the environment from one of several directions, chosen by the light that the surface would reflect from
// each. [resampled importance sampling: Talbot, Cline and Egbert 2005]
glm::dvec3 Path::light_from(const Surface& surface, const Reflection& reflection, const glm::dvec2& u)
{
    if (!world_.environment || world_.strategy == Strategy::reflections_only)
        return glm::dvec3(0.0);
    const int count = static_cast<int>(candidates_);
    Candidate chosen;
    double total = 0.0;
    for (int i = 0; i < count; ++i) {
        // A rank-1 lattice distributes each candidate evenly over all samples, and all candidates together.
        const double x = u.x + i / candidates_, y = u.y + i * 0.6180339887498949;
        const Candidate next = candidate(surface, reflection, {x - std::floor(x), y - std::floor(y)});
        total += next.size;
        if (next.size > 0.0 && (total <= next.size || sampler_.random() * total < next.size))
            chosen = next;
    }
    if (!(chosen.size > 0.0))
        return glm::dvec3(0.0);
    const double way = world_.bounces == 0
                           ? 1.0
                           : passing(world_, {start_beside(surface.position, surface.geometric),
                                              glm::vec3(chosen.direction)});
    return (way * total / (candidates_ * chosen.size)) * chosen.light;
}

// Light of emissive surfaces, from a sampled point on one of them.
glm::dvec3 Path::light_from_emitters(const Surface& surface, const Reflection& reflection)
{
    if (!world_.emitters || world_.bounces == 0 || world_.strategy == Strategy::reflections_only)
        return glm::dvec3(0.0);
    const std::array<double, 4> u = sampler_.next4();
    Emitters::Drawn drawn = world_.emitters->draw({u[0], u[1], u[2]});
    const glm::dvec3 way = drawn.position - surface.position;
    const double distance = glm::length(way);
    const glm::dvec3 direction = way / std::max(distance, 1e-30);
    const double cosine = -glm::dot(drawn.normal, direction);
    drawn.hit.front = cosine > 0.0;
    if (!(std::fabs(cosine) > 1e-9) || world_.surfaces->is_culled(drawn.hit) || below(surface, direction))
        return glm::dvec3(0.0);
    const glm::dvec3 value = reflection.value(direction);
    if (value == glm::dvec3(0.0))
        return value;
    trace::Ray ray{start_beside(surface.position, surface.geometric), glm::vec3(direction)};
    ray.far = static_cast<float>(distance * (1.0 - 1e-4));
    const double there = passing(world_, ray) * world_.surfaces->opacity(drawn.hit);
    if (!(there > 0.0))
        return glm::dvec3(0.0);
    const double density = drawn.density * distance * distance / std::fabs(cosine);
    const bool alone = world_.strategy == Strategy::lights_only;
    const double weight = alone ? 1.0 : weight_of(density, reflection.density(direction));
    return (there * weight / density) * value *
           emitted_by(world_.surfaces->at(drawn.hit, direction), world_.energy_compensation);
}

// Light emitted by a surface that the path met. After a bounce, its weight complements that of light_from_emitters.
// Culled backs of one-sided surfaces emit nothing.
glm::dvec3 Path::emitted(const trace::Hit& hit, const Surface& surface, int bounce) const
{
    if (world_.surfaces->is_culled(hit))
        return glm::dvec3(0.0);
    const double by_area = world_.emitters && !surface.unlit ? world_.emitters->density(hit.instance) : 0.0;
    if (bounce == 0 || !(by_area > 0.0) || world_.strategy == Strategy::reflections_only)
        return emitted_by(surface, world_.energy_compensation);
    if (world_.strategy == Strategy::lights_only)
        return glm::dvec3(0.0);
    const glm::dvec3 way = surface.position - last_;
    const double cosine = std::max(glm::dot(surface.geometric, surface.view), 1e-9);
    return weight_of(density_, by_area * glm::dot(way, way) / cosine) *
           emitted_by(surface, world_.energy_compensation);
}

glm::dvec3 Path::lamp(const scene::Light& light, const Surface& surface, const Reflection& reflection) const
{
    const LightArrival arrival = arrival_of(light, surface.position);
    if (arrival.illuminance == glm::dvec3(0.0) || below(surface, arrival.direction))
        return glm::dvec3(0.0);
    const glm::dvec3 value = reflection.value(arrival.direction);
    if (value == glm::dvec3(0.0) || world_.bounces == 0)
        return value * arrival.illuminance;
    trace::Ray ray{start_beside(surface.position, surface.geometric), glm::vec3(arrival.direction)};
    ray.far = static_cast<float>(arrival.distance);
    return passing(world_, ray) * value * arrival.illuminance;
}

// Light of all lights without size, or an estimate from one of them if there are many.
glm::dvec3 Path::lamps(const Surface& surface, const Reflection& reflection)
{
    const std::size_t count = world_.lights.size();
    if (count > most_lights_at_once) {
        const auto chosen = static_cast<std::size_t>(sampler_.random() * static_cast<double>(count));
        return static_cast<double>(count) * lamp(world_.lights[chosen], surface, reflection);
    }
    glm::dvec3 sum(0.0);
    for (const scene::Light& light : world_.lights)
        sum += lamp(light, surface, reflection);
    return sum;
}

// Direct light that a surface reflects. Also samples the direction in which the path continues.
glm::dvec3 Path::scattered(const Surface& surface)
{
    const Reflection reflection(surface, world_.model, world_.energy_compensation);
    const std::array<double, 4> u = sampler_.next4();
    candidates_ = reflection.is_wide() ? most_candidates : 1;
    glm::dvec3 light = lamps(surface, reflection) + light_from(surface, reflection, {u[0], u[1]}) +
                       light_from_emitters(surface, reflection);
    light *= throughput_;
    next_ = reflection.draw({u[2], u[3]});
    density_ = below(surface, next_) ? 0.0 : reflection.density(next_);
    if (!(density_ > 0.0))
        return light;
    throughput_ *= reflection.value(next_) / density_;
    if (throughput_ == glm::dvec3(0.0))
        density_ = 0.0;
    return light;
}

glm::dvec3 Path::background(const glm::dvec3& direction)
{
    using Kind = view::Background::Kind;
    const view::Background& b = world_.background;
    if (b.kind == Kind::color)
        return glm::dvec3(b.color);
    if (b.kind == Kind::none || !world_.environment)
        return glm::dvec3(0.0);
    return world_.environment->radiance(b.kind == Kind::blurred ? blurred(direction, b.roughness, sampler_)
                                                                : direction);
}

// Light of the environment from the direction that was sampled at the last surface.
glm::dvec3 Path::escaped(const glm::dvec3& direction) const
{
    if (!world_.environment || world_.strategy == Strategy::lights_only)
        return glm::dvec3(0.0);
    const bool alone = world_.strategy == Strategy::reflections_only;
    const glm::dvec2 place = world_.environment->place_of(direction);
    const double weight =
        alone ? 1.0 : weight_of(density_, candidates_ * world_.environment->density_at(place));
    return weight * throughput_ * world_.environment->radiance_at(place);
}

bool Path::survives(int bounce)
{
    if (bounce < least_bounces)
        return true;
    const double chance = std::min(std::max({throughput_.x, throughput_.y, throughput_.z}), 0.95);
    if (!(sampler_.random() < chance))
        return false;
    throughput_ /= chance;
    return true;
}

// The noise of a blurred background is for the denoiser to take away; any other is known as it is.
void Path::note_background(const glm::dvec3& radiance)
{
    const bool is_noisy = world_.background.kind == view::Background::Kind::blurred;
    *first_ = {};
    (is_noisy ? first_->albedo : first_->emitted) = is_noisy ? glm::dvec3(1.0) : radiance;
}

void Path::note_surface(const Surface& surface, const glm::dvec3& origin, const glm::dvec3& emission)
{
    first_->emitted = emission;
    first_->albedo = surface.unlit ? glm::dvec3(0.0)
                                   : Reflection(surface, world_.model, world_.energy_compensation).albedo();
    first_->normal = surface.normal;
    first_->depth = glm::length(surface.position - origin);
}

Sight Path::follow(const SightRay& sight)
{
    Sight seen;
    trace::Ray ray{glm::vec3(sight.origin), glm::vec3(sight.direction), static_cast<float>(sight.near),
                   static_cast<float>(sight.far)};
    glm::dvec3 direction = sight.direction;
    for (int bounce = 0;; ++bounce) {
        // Without shadows nothing blocks sampled directions.
        const bool open = bounce > 0 && world_.bounces == 0;
        const trace::Hit hit =
            open ? trace::Hit()
                 : first_obstacle(world_, ray, bounce == 0 ? RayOf::camera : RayOf::light, sampler_);
        if (!hit.found()) {
            if (bounce > 0) {
                seen.radiance += escaped(direction);
                return seen;
            }
            seen.radiance = background(direction);
            if (first_)
                note_background(seen.radiance);
            return seen;
        }
        const Surface surface = world_.surfaces->at(hit, direction);
        seen.coverage = 1.0;
        seen.radiance += throughput_ * emitted(hit, surface, bounce);
        if (bounce == 0 && first_)
            note_surface(surface, sight.origin, seen.radiance);
        seen.unlit = seen.unlit || (bounce == 0 && surface.unlit);
        if (surface.unlit || (bounce > 0 && bounce >= world_.bounces))
            return seen;
        seen.radiance += scattered(surface);
        if (!(density_ > 0.0) || !survives(bounce))
            return seen;
        direction = next_;
        last_ = surface.position;
        ray = {start_beside(surface.position, surface.geometric), glm::vec3(direction)};
    }
}

} // namespace

Sight trace_path(const World& world, const SightRay& ray, SampleSequence& sampler, FirstSurface* first)
{
    return Path(world, sampler, first).follow(ray);
}

} // namespace lambent::reference
