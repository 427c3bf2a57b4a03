#include "apps/report/oval.h"

#include "image/luminance.h"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace lambent::report {
namespace {

class Moments {
public:
    void add(const glm::dvec2& p, double weight)
    {
        weight_ += weight;
        sum_ += weight * p;
        squares_ += weight * p * p;
        product_ += weight * p.x * p.y;
        ++count_;
    }

    double aspect() const
    {
        if (count_ < 3)
            return 0.0;
        const glm::dvec2 mean = sum_ / weight_, variance = squares_ / weight_ - mean * mean;
        const double covariance = product_ / weight_ - mean.x * mean.y;
        const double middle = 0.5 * (variance.x + variance.y),
                     apart = std::hypot(0.5 * (variance.x - variance.y), covariance);
        return std::sqrt((middle + apart) / std::max(middle - apart, 1e-30));
    }

private:
    int count_ = 0;
    double weight_ = 0.0, product_ = 0.0;
    glm::dvec2 sum_{0.0}, squares_{0.0};
};

} // namespace

Oval highlight_shape(const image::RadianceImage& light, const view::Camera& camera)
{
    double brightest = 0.0;
    for (int y = 0; y < light.height; ++y)
        for (int x = 0; x < light.width; ++x)
            brightest = std::max(brightest, image::luminance(light.pixel(x, y)));
    const view::RayMap rays = view::ray_map(camera, light.width, light.height);
    Moments ground, picture;
    for (int y = 0; y < light.height; ++y)
        for (int x = 0; x < light.width; ++x) {
            if (brightest <= 0.0 || image::luminance(light.pixel(x, y)) < 0.5 * brightest)
                continue;
            const glm::dvec2 at(x + 0.5, y + 0.5);
            const glm::dvec3 origin = glm::dvec3(rays.origin) + at.x * glm::dvec3(rays.origin_dx) +
                                      at.y * glm::dvec3(rays.origin_dy);
            const glm::dvec3 direction = glm::dvec3(rays.direction) + at.x * glm::dvec3(rays.direction_dx) +
                                         at.y * glm::dvec3(rays.direction_dy);
            const double t = -origin.y / direction.y;
            if (!(t > 0.0))
                continue;
            const glm::dvec3 point = origin + t * direction;
            // A distant pixel, or one at a grazing angle, covers more ground.
            ground.add({point.x, point.z}, t * t * t / std::fabs(origin.y));
            picture.add(at, 1.0);
        }
    return {ground.aspect(), picture.aspect()};
}

} // namespace lambent::report
