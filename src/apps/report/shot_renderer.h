// Where the pictures of the page are made: everything that two of them share is made once.
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
    Words size, rotation; ///< options for every shot; none: what `render` takes
    bool cache = true;    ///< of environments
    double noise = 0.02;  ///< of references: stop at this estimated relative error of what surfaces cover,
    int samples = 48;     ///< or at so many samples per pixel
    std::filesystem::path folder; ///< to be filled with files
    std::function<void(double)>
        progress; ///< told the seconds of work that a thing was reckoned to take, when done
};

/// Light is cut at this for comparing: half of full white at exposure 1. The report's BRDF has no bound at grazing
/// angles, and a few pixels there would be all that a mean square sees.
constexpr float light_cut = 1.0f;

/// Light so cut.
image::RadianceImage cut_light(image::RadianceImage light);

/// The estimated error of a reference over all its pixels, its light cut, relative to its mean.
/// Nothing where it is not known: see reference::Film::noise.
std::optional<double> cut_noise(const reference::Result& exact);

/// What is left of a relative error without the reference's noise, which is independent of it: their squares differ by
/// it. Where that is not known, nothing is taken off.
double without_noise(double error, const std::optional<double>& noise);

/// A picture beside its path-traced reference, both cut.
struct Proof {
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

    /// Draws a shot and writes its file, with its command and no numbers yet.
    PagePicture picture(const Shot& shot);

    /// A shot's light; drawn at the first call. Stays where it is.
    const draw::Frame& frame(const Shot& shot);

    /// The same with all layers, not kept.
    draw::Frame layers(const Shot& shot);

    /// A shot's codes, as in its file.
    image::CodeImage codes(const Shot& shot);

    /// The reference of a shot, traced at the first call for its light, without shadows. Stays where it is.
    const reference::Result& reference(const Shot& shot);

    /// Compares a shot with its reference and writes both pictures of that.
    Proof prove(const Shot& shot);

    /// All words of a shot's command between `lambent render` and -o.
    Words words_of(const Shot& shot) const;

    /// Where the shot looks from.
    view::Camera camera(const Shot& shot);

    /// Writes codes as a file of the folder, in the background.
    void write(image::CodeImage codes, const std::string& name);

    /// Waits for all files and names them. Throws Error(cannot_write).
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
    std::unique_ptr<Stage> stage_; ///< the scene at work
    std::map<std::string, std::optional<environment::Environment>> environments_;
    std::map<std::string, std::optional<image::RadianceImage>> raw_environments_;
    std::map<Words, draw::Frame> frames_;
    std::map<Words, reference::Result> references_;
    std::vector<std::string> files_;
    tbb::task_group writing_;
};

} // namespace lambent::report
