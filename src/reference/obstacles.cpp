#include "reference/obstacles.h"

namespace lambent::reference {
namespace {

// A ray ends after passing through this many backs and transparent surfaces.
constexpr int most_layers = 256;

// Start of the rest of a ray, just behind a hit.
float behind(const trace::Hit& hit)
{
    return hit.distance * (1.0f + 1e-5f) + 1e-30f;
}

// The nearest hit of a ray. Points and lines are visible to camera rays only.
trace::Hit nearest(const World& world, trace::Ray ray, RayOf whose)
{
    const trace::Hit hit = world.visibility->nearest(ray);
    if (whose == RayOf::light || !world.lines)
        return hit;
    if (hit.found())
        ray.far = hit.distance;
    const trace::Hit line = world.lines->nearest(ray);
    return line.found() ? line : hit;
}

} // namespace

trace::Hit first_obstacle(const World& world, trace::Ray ray, RayOf whose, SampleSequence& sampler)
{
    for (int layer = 0; layer < most_layers; ++layer) {
        const trace::Hit hit = nearest(world, ray, whose);
        if (!hit.found())
            return hit;
        if (whose == RayOf::light || !world.surfaces->is_culled(hit)) {
            const double opacity = world.surfaces->opacity(hit);
            if (opacity >= 1.0 || (opacity > 0.0 && sampler.random() < opacity))
                return hit;
        }
        ray.near = behind(hit);
    }
    return {};
}

double passing(const World& world, trace::Ray ray)
{
    double left = 1.0;
    for (int layer = 0; layer < most_layers; ++layer) {
        const trace::Hit hit = world.visibility->nearest(ray);
        if (!hit.found())
            return left;
        left *= 1.0 - world.surfaces->opacity(hit);
        if (!(left > 0.0))
            return 0.0;
        ray.near = behind(hit);
    }
    return 0.0;
}

} // namespace lambent::reference
