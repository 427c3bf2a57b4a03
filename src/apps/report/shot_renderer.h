// Draws and traces the pictures of the page. What several shots share is made once: environments, frames, references.
#pragma once

#include "apps/report/page.h"
#include "apps/report/shot.h"
#include "draw/renderer.h"
#include "reference/tracer.h"

#include <tbb/task_group.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace lambent::report {

struct ShotRendererSettings {
    std::string environment = "kitchen";
    Words size, rotation;                 ///< options of every shot; empty: the defaults of `render`
    bool cache = true;                    ///< whether prepared environments are cached
    double noise = 0.02;                  ///< references stop at this estimated relative error on surfaces,
    int samples = 48;                     ///< or at this number of samples per pixel
    std::filesystem::path folder;         ///< receives the files
    std::function<void(double)> progress; ///< called after each piece of work with its estimated seconds
};

/// Radiance is clamped to this before comparing: half of full white at exposure 1. The report's BRDF is unbounded at
/// grazing angles, where a few pixels would dominate a mean square.
constexpr float light_clamp = 1.0f;

/// The radiance clamped to light_clamp.
image::RadianceImage clamped_light(image::RadianceImage light);

/// The estimated relative error of a reference, its radiance clamped, over all its pixels. Empty where it is unknown:
/// see reference::Film::noise.
std::optional<double> clamped_noise(const reference::Result& exact);

/// A relative error without the reference's noise, which is independent of it: sqrt(error^2 - noise^2), at least 0. The
/// error as it is where the noise is unknown.
double without_noise(double error, const std::optional<double>& noise);

/// A picture compared with its path-traced reference, both clamped.
struct ReferenceComparison {
    PagePicture reference, heat;
    double error = 0.0;          ///< relative RMSE, as `lambent compare` measures it
    std::optional<double> noise; ///< the reference's own, estimated
    double flip = 0.0;           ///< mean HDR-FLIP
};

class ShotRenderer {
public:
    explicit ShotRenderer(ShotRendererSettings settings);
    ~ShotRenderer();
    ShotRenderer(const ShotRenderer&) = delete;
    ShotRenderer& operator=(const ShotRenderer&) = delete;

    /// Draws a shot and writes its file. The result has the shot's command and no numbers.
    PagePicture picture(const Shot& shot);

    /// A shot's frame, drawn at the first call and kept as long as the renderer.
    const draw::Frame& frame(const Shot& shot);

    /// The same frame with all layers; drawn at each call.
    draw::Frame layers(const Shot& shot);

    /// A shot's codes, as in its file.
    image::CodeImage codes(const Shot& shot);

    /// A shot's path-traced reference, without shadows; traced at the first call and kept as long as the renderer.
    const reference::Result& reference(const Shot& shot);

    /// Compares a shot with its reference, and writes the reference's picture and the heat map.
    ReferenceComparison compare_with_reference(const Shot& shot);

    /// All words of a shot's command between `lambent render` and -o.
    Words words_of(const Shot& shot) const;

    /// The shot's camera.
    view::Camera camera(const Shot& shot);

    /// Writes codes as a file of the folder, in the background.
    void write(image::CodeImage codes, const std::string& name);

    /// Waits until all files are written and returns their names. Throws Error(cannot_write).
    std::vector<std::string> finish();

    const ShotRendererSettings& settings() const { return settings_; }
    Warnings warnings() const { return warnings_; }

private:
    struct Stage;

    const scene::Scene& scene_of(const cli::RenderArguments& arguments);
    draw::Frame draw(const cli::RenderArguments& arguments);
    const environment::Environment* environment(const std::string& name);
    const image::RadianceImage* raw_environment(const std::string& name);
    Words reference_words(const Shot& shot) const;
    PagePicture reference_picture(const Shot& shot);
    PagePicture heat_picture(const Shot& shot);
    void done(double seconds);

    ShotRendererSettings settings_;
    Warnings warnings_;
    std::unique_ptr<Stage> stage_; ///< the current scene
    std::map<std::string, std::optional<environment::Environment>> environments_;
    std::map<std::string, std::optional<image::RadianceImage>> raw_environments_;
    std::map<Words, draw::Frame> frames_;
    std::map<Words, reference::Result> references_;
    std::vector<std::string> files_;
    tbb::task_group writing_;
};

} // namespace lambent::report
