// The environment as a light: the panorama itself, read between its texels, and directions drawn in proportion to it.
#pragma once

#include "image/image.h"
#include "image/panorama_rows.h"
#include "reference/discrete_distribution.h"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

#include <vector>

namespace lambent::reference {

/// Light that arrives from infinitely far away, RGB radiance by direction: bilinear between the texels of an
/// equirectangular picture, columns going round, rows lying at image::row_angles() and going on across the poles, so that
/// each texel gives its radiance times its solid angle, a sun in the zenith too.
class EnvironmentLight {
public:
    /// Finite, not negative RGB, at least 2x1; must outlive this. rotation as view::Picture::environment_rotation.
    EnvironmentLight(const image::RadianceImage& panorama, double rotation);

    glm::dvec3 radiance(const glm::dvec3& direction) const { return radiance_at(place_of(direction)); }

    /// A direction, where it is in the panorama (0 to 1 along each axis), and its density per solid angle: 0 if the
    /// whole environment is black.
    struct Drawn {
        glm::dvec3 direction{0.0};
        glm::dvec2 place{0.0};
        double density = 0.0;
    };
    /// Drawn by the luminance of cells of one or more texels, each cell's being the mean of the bilinear picture over
    /// it; within a cell uniformly per solid angle. [Pharr, Jakob and Humphreys 2016, 14.2.4]
    Drawn draw(const glm::dvec2& u) const;

    /// Density of draw() at a unit direction.
    double density(const glm::dvec3& direction) const { return density_at(place_of(direction)); }

    /// The same by place: finding that is most of the work.
    glm::dvec2 place_of(const glm::dvec3& direction) const;
    glm::dvec3 radiance_at(const glm::dvec2& uv) const;
    double density_at(const glm::dvec2& uv) const;

private:
    void fill_cells();
    double smoothed_luminance(int x, int y) const;
    double cell_light(int column, int row) const;
    double cell_density(std::size_t row, std::size_t column) const;

    const image::RadianceImage& panorama_;
    double cosine_, sine_;
    image::PanoramaRows picture_rows_;
    int columns_ = 0, rows_ = 0;                       ///< of cells
    DiscreteDistribution<double> row_choice_;          ///< of a row of cells
    std::vector<DiscreteDistribution<float>> choices_; ///< within each row; in double they fill the caches
    std::vector<double> cell_angle_;                   ///< solid angle of each row's cells
    std::vector<double> edge_cosines_;                 ///< of the polar angle where rows begin and end
};

} // namespace lambent::reference
