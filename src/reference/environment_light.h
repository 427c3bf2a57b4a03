// The environment as a light source: radiance of the panorama itself, and directions sampled in proportion to it.
#pragma once

#include "image/image.h"
#include "image/panorama_rows.h"
#include "reference/discrete_distribution.h"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

#include <vector>

namespace lambent::reference {

/// Light from infinitely far away: RGB radiance by direction, bilinear between the texels of an equirectangular
/// panorama. Columns wrap around; rows lie at image::row_angles() and continue across the poles. Each texel therefore
/// gives its radiance times its solid angle, even for a sun in the zenith.
class EnvironmentLight {
public:
    /// `panorama`: RGB, finite, not negative, at least 2x1; it must outlive this object. `rotation` as
    /// view::Picture::environment_rotation.
    EnvironmentLight(const image::RadianceImage& panorama, double rotation);

    glm::dvec3 radiance(const glm::dvec3& direction) const { return radiance_at(place_of(direction)); }

    /// A direction, its position in the panorama (0 to 1 along each axis), and its density per solid angle, which is
    /// 0 if the whole environment is black.
    struct Drawn {
        glm::dvec3 direction{0.0};
        glm::dvec2 place{0.0};
        double density = 0.0;
    };
    /// Samples a cell of one or more texels by its luminance, the mean of the bilinear panorama over it, then a
    /// direction in the cell uniformly per solid angle. [Pharr, Jakob and Humphreys 2016, 14.2.4]
    Drawn draw(const glm::dvec2& u) const;

    /// Density of draw() at a unit direction.
    double density(const glm::dvec3& direction) const { return density_at(place_of(direction)); }

    /// The same by position in the panorama, whose computation takes most of the time.
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
    int columns_ = 0, rows_ = 0;                       ///< numbers of cells
    DiscreteDistribution<double> row_choice_;          ///< chooses a row of cells
    std::vector<DiscreteDistribution<float>> choices_; ///< choose a cell of a row; doubles fill the caches
    std::vector<double> cell_angle_;                   ///< solid angle of a cell in each row
    std::vector<double> edge_cosines_;                 ///< of the polar angle at edges of rows, from the top
};

} // namespace lambent::reference
