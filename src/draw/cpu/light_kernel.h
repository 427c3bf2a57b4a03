// Light on surfaces, on SIMD lanes: the passes of src/shading over the fragments of a tile.
#pragma once

#include "draw/settings.h"
#include "draw/cpu/fragments.h"
#include "draw/sample_tables.h"
#include "environment/environment.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace lambent::draw {

/// A light as the kernel wants it.
struct LightSource {
    bool local = false; ///< at a place, else from a direction
    glm::vec3 position{0.0f};
    glm::vec3 intensity{0.0f};                  ///< candela, or lux
    glm::vec3 axis{0.0f};                       ///< the way the light travels
    float range = 0.0f;                         ///< metres; infinite if unlimited
    float cos_inner = -2.0f, cos_outer = -3.0f; ///< below -1: not a spot
};

/// What all fragments of a picture share.
struct LightContext {
    Model model = Model::ggx;
    MipLevel mip_level = MipLevel::matched;
    bool energy_compensation = true;
    float ambient_brightness = 1.0f;
    const environment::Environment* environment = nullptr;         ///< null: none
    const std::vector<environment::Panorama>* mip_chain = nullptr; ///< the report's, for MipLevel::report
    glm::vec3 across{1.0f, 0.0f, 0.0f}; ///< to the right of the camera, unit length
    float rotation_cosine = 1.0f, rotation_sine = 0.0f;
    const SampleTables* tables = nullptr;
};

/// Adds the direct light of `lights` to direct_* of the fragments [begin, end).
void light_directly(const LightContext& context, std::span<const LightSource> lights, std::size_t begin,
                    std::size_t end, Fragments& fragments);

/// Fills irradiance_* and ambient_*.
void light_ambiently(const LightContext& context, std::size_t begin, std::size_t end, Fragments& fragments);

/// Fills reflected_*: the specular light of the environment.
void light_specularly(const LightContext& context, std::size_t begin, std::size_t end, Fragments& fragments);

/// Radiance of the environment along rays of sight, for the background.
struct BackgroundRow {
    float y = 0.0f;      ///< of the pixels' centres
    int first_x = 0;     ///< pixel
    int count = 0;       ///< pixels
    float level = -1.0f; ///< of blur; below 0: the panorama itself
};
/// Writes RGB to three arrays of `count` floats rounded up to 16.
void light_background(const LightContext& context, const RayMap& rays, const BackgroundRow& row,
                      float* const rgb[3]);

} // namespace lambent::draw
