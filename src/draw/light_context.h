// What the light of a picture depends on besides its surfaces.
#pragma once

#include "draw/sample_tables.h"
#include "draw/settings.h"
#include "environment/environment.h"

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace lambent::draw {

/// A light as the passes want it.
struct LightSource {
    bool local = false; ///< at a place, else from a direction
    glm::vec3 position{0.0f};
    glm::vec3 intensity{0.0f};                  ///< candela, or lux
    glm::vec3 axis{0.0f};                       ///< the way the light travels
    float range = 0.0f;                         ///< metres; infinite if unlimited
    float cos_inner = -2.0f, cos_outer = -3.0f; ///< below -1: not a spot
};

/// The powers of ReportPipeline; see shading/lobes/pipeline_report.glsl.
struct ReportPowers {
    float decode, exposure, encode, back;
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
    std::optional<ReportPowers> pipeline; ///< the report's own; unset: light
    bool middle_level = false;            ///< fill that column
};

} // namespace lambent::draw
