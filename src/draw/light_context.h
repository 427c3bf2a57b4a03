// The inputs of the light passes other than surfaces: lights, environment, settings.
#pragma once

#include "draw/sample_tables.h"
#include "draw/settings.h"
#include "environment/environment.h"

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace lambent::draw {

/// A light in the form that the passes read.
struct LightSource {
    bool local = false; ///< at `position`; else infinitely far away
    glm::vec3 position{0.0f};
    glm::vec3 intensity{0.0f};                  ///< candela if local, else lux
    glm::vec3 axis{0.0f};                       ///< direction in which the light travels, unit length
    float range = 0.0f;                         ///< metres; infinite if unlimited
    float cos_inner = -2.0f, cos_outer = -3.0f; ///< of the cone angles; below -1 if not a spot
};

/// Exponents and factor of ReportPipeline; see shading/lobes/pipeline_report.glsl.
struct ReportPowers {
    float decode, exposure, encode, back;
};

/// Data shared by all fragments of a picture.
struct LightContext {
    Model model = Model::ggx;
    MipLevel mip_level = MipLevel::matched;
    bool energy_compensation = true;
    float ambient_brightness = 1.0f;
    const environment::Environment* environment = nullptr;         ///< null if there is none
    const std::vector<environment::Panorama>* mip_chain = nullptr; ///< of the panorama, for MipLevel::report
    glm::vec3 across{1.0f, 0.0f, 0.0f}; ///< the camera's right direction, unit length
    float rotation_cosine = 1.0f, rotation_sine = 0.0f;
    const SampleTables* tables = nullptr;
    std::optional<ReportPowers> pipeline; ///< if set, the passes add up code values instead of radiance
    bool middle_level = false;            ///< whether to fill column_middle_level
};

} // namespace lambent::draw
