// A picture whose truth is traced once, so that it can be audited hundreds of times.
#pragma once

#include "audit/audit.h"
#include "image/image.h"
#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace lambent::audit::testing {

/// A picture and what is wrong with it: drawn without shadows, or traced with few samples.
struct Kind {
    std::string scene, environment; ///< built in
    int bounces = 0;                ///< of the truth
    double exposure = 1.0;
    int samples = 0; ///< of a traced picture; 0: drawn
};

std::string name_of(const Kind& kind);

struct Size {
    int width = 0, height = 0;
};

/// All that an audit takes.
struct Subject {
    scene::Scene scene;
    image::RadianceImage panorama, picture;
    reference::Settings truth;
    double cut = 1.0;
};

Subject subject_of(const Kind& kind, const Size& size);

/// The true error, of all covered pixels against two long traces of each, so that their noise does not count.
struct TrueError {
    std::size_t covered = 0;
    double relative_mse = 0.0;

    double relative_rmse() const { return std::sqrt(std::max(relative_mse, 0.0)); }
};

/// `samples`: paths of each of the two.
TrueError true_error(const Subject& subject, int samples);

/// A subject with short estimates of each covered pixel, of which an audit takes some. Audits then share the noise of
/// these few: good enough for pictures whose error is larger than it.
class CachedTruth {
public:
    explicit CachedTruth(const Subject& subject);

    /// What an audit says. Of the short estimates of a pixel another four are taken for each seed.
    std::optional<Error> audited(Settings settings) const;

private:
    static constexpr unsigned halves = 8, glances = 4;

    const Subject& subject_;
    std::vector<std::size_t> number_; ///< of a pixel among the covered ones
    std::array<std::vector<reference::PixelEstimate>, halves> half_;
    std::array<std::vector<reference::PixelEstimate>, glances> glance_;
};

} // namespace lambent::audit::testing
