// Invalid texels: found while a panorama is read, filled from their neighbours afterwards.
#pragma once

#include "base/error.h"
#include "environment/panorama/panorama.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace lambent::environment {

/// Texels above this count as broken: six times the radiance of the sun's disc in nits.
constexpr float brightest_valid = 1.0e10f;

class BrokenTexels {
public:
    /// Sets texels that are not finite, negative or above brightest_valid to black and remembers them.
    /// `rgb` holds whole texels; the first has the given index in the panorama.
    void blacken(std::span<float> rgb, std::size_t first_texel);

    /// Gives each remembered texel the mean of its valid neighbours, layer by layer from the rim of a patch inwards
    /// (a sun that was too bright for the file's format gets the brightness of its rim), and adds one warning.
    void mend(Panorama& panorama, const std::string& name, Warnings& warnings) const;

    /// The same for RGB in floats.
    void mend(image::RadianceImage& panorama, const std::string& name, Warnings& warnings) const;

private:
    template <class Texels>
    void mend_texels(Texels& panorama, const std::string& name, Warnings& warnings) const;

    std::vector<std::size_t> texels_; ///< ascending; those with NaN, infinity or values above brightest_valid
    std::size_t negative_ = 0;        ///< texels that only had negative components: these stay at 0
};

} // namespace lambent::environment
