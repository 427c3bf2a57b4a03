#include "kitchen/first_hits.h"

#include "reference/lens.h"
#include "reference/samples/sampler.h"
#include "reference/surface.h"
#include "trace/visibility.h"

#include <glm/common.hpp>
#include <tbb/parallel_for.h>

namespace lambent {
namespace {

// Light is divided by albedo.
constexpr float least_albedo = 0.02f;

} // namespace

std::vector<FirstHit> first_hits(const scene::Scene& scene, const PanoramaView& view)
{
    const trace::Visibility visibility(scene);
    const reference::Surfaces surfaces(scene, view::Model::ggx, view::TexelTransfer::srgb);
    const reference::Lens lens(view.viewpoint, view.width, view.height);
    std::vector<FirstHit> hits(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
    tbb::parallel_for(0, view.height, [&](int y) {
        for (int x = 0; x < view.width; ++x) {
            FirstHit& sum = hits[static_cast<std::size_t>(y * view.width + x)];
            glm::vec3 albedo(0.0f);
            const float share = 1.0f / static_cast<float>(view.samples);
            for (int i = 0; i < view.samples; ++i) {
                reference::SampleSequence sampler(
                    hashed(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)),
                    static_cast<std::uint32_t>(i));
                const auto place = sampler.next4();
                const reference::SightRay ray = lens.through(x + place[0], y + place[1]);
                const trace::Hit hit = visibility.nearest({glm::vec3(ray.origin), glm::vec3(ray.direction)});
                if (!hit.found()) {
                    albedo += share;
                    continue;
                }
                const reference::Surface surface = surfaces.at(hit, ray.direction);
                albedo += share * glm::max(glm::vec3(surface.material.base_color), glm::vec3(least_albedo));
                sum.normal += share * glm::vec3(surface.normal);
                sum.position += share * (glm::vec3(surface.position) - view.viewpoint);
                sum.coverage += share;
            }
            sum.albedo = albedo;
        }
    });
    return hits;
}

} // namespace lambent
