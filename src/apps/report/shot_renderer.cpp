#include "apps/report/shot_renderer.h"

#include "apps/common/load_environment.h"
#include "apps/common/picture_setup.h"
#include "apps/common/reference_setup.h"
#include "base/text.h"
#include "compare/difference.h"
#include "compare/flip.h"
#include "compare/heat_map.h"
#include "compare/image_pair.h"
#include "draw/cpu/cpu_renderer.h"
#include "draw/line_renderer.h"
#include "image/files/image_io.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace lambent::report {
namespace {

// Estimated seconds of work on two cores, for the progress bar.
constexpr double seconds_of_a_drawing = 0.1, seconds_of_a_reference = 4.0, seconds_of_a_comparison = 0.5;

std::string scene_key(const cli::RenderArguments& arguments)
{
    const auto color = [](const std::optional<glm::vec3>& c) {
        return c ? text(c->x, ",", c->y, ",", c->z) : std::string();
    };
    const scene::BuiltinOptions& o = arguments.builtin;
    return text(arguments.scene, " ", o.density, " ", color(o.diffuse), " ", color(o.specular), " ",
                o.exponent.value_or(0.0f));
}

void append(Words& words, const Words& more)
{
    words.insert(words.end(), more.begin(), more.end());
}

Words output_words(const char* command, Words words, const std::string& file)
{
    words.insert(words.begin(), {"lambent", command});
    words.insert(words.end(), {"-o", file});
    return words;
}

} // namespace

image::RadianceImage clamped_light(image::RadianceImage light)
{
    compare::clamp(light, light_clamp);
    return light;
}

// References are traced at exposure 1, at which their noise is estimated of radiance clamped to light_clamp.
std::optional<double> clamped_noise(const reference::Result& exact)
{
    return exact.noise ? std::optional(exact.noise->all) : std::nullopt;
}

double without_noise(double error, const std::optional<double>& noise)
{
    return noise ? std::sqrt(std::max(0.0, error * error - *noise * *noise)) : error;
}

// A scene and its renderer, which refers to it.
struct ShotRenderer::Stage {
    std::string key;
    scene::Scene scene;
    std::unique_ptr<draw::Renderer> renderer;
};

ShotRenderer::ShotRenderer(ShotRendererSettings settings) : settings_(std::move(settings)) {}

ShotRenderer::~ShotRenderer()
{
    writing_.cancel();
    try {
        writing_.wait();
    } catch (...) { // finish() reports errors, a destructor cannot
    }
}

void ShotRenderer::done(double seconds)
{
    if (settings_.progress)
        settings_.progress(seconds);
}

Words ShotRenderer::words_of(const Shot& shot) const
{
    std::istringstream stream(shot.words);
    Words words{std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
    // A shot may set its own environment or size.
    if (std::find(words.begin(), words.end(), "--env") == words.end()) {
        append(words, {"--env", shot.lit ? settings_.environment : "none"});
        if (shot.lit)
            append(words, settings_.rotation);
    }
    if (std::find(words.begin(), words.end(), "--size") == words.end())
        append(words, settings_.size);
    append(words, {"--bounces", "0"}); // the report has no shadows
    return words;
}

const scene::Scene& ShotRenderer::scene_of(const cli::RenderArguments& arguments)
{
    const std::string key = scene_key(arguments);
    if (!stage_ || stage_->key != key) {
        stage_ = std::make_unique<Stage>();
        stage_->key = key;
        stage_->scene = cli::load_scene(arguments, warnings_);
    }
    return stage_->scene;
}

const environment::Environment* ShotRenderer::environment(const std::string& name)
{
    auto found = environments_.find(name);
    if (found == environments_.end()) {
        cli::LoadedEnvironment loaded = cli::load_environment(name, settings_.cache);
        append(warnings_, loaded.warnings);
        found = environments_.emplace(name, std::move(loaded.environment)).first;
    }
    return found->second ? &*found->second : nullptr;
}

const image::RadianceImage* ShotRenderer::raw_environment(const std::string& name)
{
    auto found = raw_environments_.find(name);
    if (found == raw_environments_.end()) {
        Warnings said_before;
        found = raw_environments_.emplace(name, cli::load_raw_environment(name, said_before)).first;
    }
    return found->second ? &*found->second : nullptr;
}

draw::Frame ShotRenderer::draw(const cli::RenderArguments& arguments)
{
    const scene::Scene& scene = scene_of(arguments);
    if (!stage_->renderer)
        stage_->renderer = draw::with_lines(draw::make_cpu_renderer(scene), scene);
    draw::Settings settings = arguments.settings;
    settings.camera = cli::choose_camera(arguments, scene);
    settings.layers = !arguments.layers.empty();
    draw::Frame frame = stage_->renderer->draw(environment(arguments.environment), settings);
    done(seconds_of_a_drawing);
    return frame;
}

const draw::Frame& ShotRenderer::frame(const Shot& shot)
{
    const Words words = words_of(shot), key = without_display(words);
    auto found = frames_.find(key);
    if (found == frames_.end())
        found = frames_.emplace(key, draw(parse_render(words))).first;
    return found->second;
}

draw::Frame ShotRenderer::layers(const Shot& shot)
{
    cli::RenderArguments arguments = parse_render(words_of(shot));
    arguments.layers = "layers";
    return draw(arguments);
}

image::CodeImage ShotRenderer::codes(const Shot& shot)
{
    return display::to_codes(frame(shot).radiance, parse_render(words_of(shot)).display);
}

view::Camera ShotRenderer::camera(const Shot& shot)
{
    const cli::RenderArguments arguments = parse_render(words_of(shot));
    return cli::choose_camera(arguments, scene_of(arguments));
}

PagePicture ShotRenderer::picture(const Shot& shot)
{
    image::CodeImage image = codes(shot);
    const std::string file =
        image::file_kind(shot.name) == image::FileKind::unknown ? shot.name + ".png" : shot.name;
    PagePicture picture{file, image.width, image.height, shot.title, shot.alt, {}, {}};
    picture.commands = {typed(output_words("render", words_of(shot), file))};
    write(std::move(image), file);
    return picture;
}

// Includes display options.
Words ShotRenderer::reference_words(const Shot& shot) const
{
    Words words = without_approximations(words_of(shot));
    append(words, {"--noise", text(settings_.noise), "--spp", text(settings_.samples)});
    return words;
}

const reference::Result& ShotRenderer::reference(const Shot& shot)
{
    const Words words = without_display(reference_words(shot));
    auto found = references_.find(words);
    if (found == references_.end()) {
        const cli::ReferenceArguments arguments = parse_reference(words);
        const scene::Scene& scene = scene_of(arguments.picture);
        double told = 0.0;
        reference::Result result = reference::trace(scene, raw_environment(arguments.picture.environment),
                                                    cli::reference_settings(arguments, scene),
                                                    [&](const reference::Progress& progress) {
                                                        done((progress.done - told) * seconds_of_a_reference);
                                                        told = progress.done;
                                                        return true;
                                                    });
        done((1.0 - told) * seconds_of_a_reference);
        found = references_.emplace(words, std::move(result)).first;
    }
    return found->second;
}

PagePicture ShotRenderer::reference_picture(const Shot& shot)
{
    const std::string file = shot.name + "-reference.png";
    image::CodeImage seen = display::to_codes(reference(shot).radiance, parse_render(words_of(shot)).display);
    PagePicture picture{file, seen.width, seen.height, "path-traced", "Path-traced: " + shot.alt, {}, {}};
    picture.commands = {typed(output_words("reference", reference_words(shot), file))};
    write(std::move(seen), file);
    return picture;
}

PagePicture ShotRenderer::heat_picture(const Shot& shot)
{
    const compare::ErrorMap map = compare::relative_error(
        {clamped_light(frame(shot).radiance), clamped_light(reference(shot).radiance)});
    image::CodeImage heat = compare::heat_map(map, {"relative error", 1.0, compare::mean(map)});
    const std::string file = shot.name + "-error.png", drawn = shot.name + ".exr",
                      traced = shot.name + "-reference.exr";
    PagePicture picture{file, heat.width, heat.height, shot.title, "Error map: " + shot.alt, {}, {}};
    picture.commands = {
        typed(output_words("render", without_display(words_of(shot)), drawn)),
        typed(output_words("reference", without_display(reference_words(shot)), traced)),
        typed(output_words("compare", {drawn, traced, "--clamp", text(light_clamp), "--heat", "relative"},
                           file))};
    write(std::move(heat), file);
    return picture;
}

ReferenceComparison ShotRenderer::compare_with_reference(const Shot& shot)
{
    const image::RadianceImage drawn = clamped_light(frame(shot).radiance),
                               exact = clamped_light(reference(shot).radiance);
    const compare::Pair pair{drawn, exact};
    ReferenceComparison comparison;
    comparison.reference = reference_picture(shot);
    comparison.heat = heat_picture(shot);
    comparison.error = compare::difference(pair, light_clamp).relative_rmse;
    comparison.noise = clamped_noise(reference(shot));
    comparison.flip = compare::mean(compare::hdr_flip(pair).map);
    done(seconds_of_a_comparison);
    return comparison;
}

void ShotRenderer::write(image::CodeImage codes, const std::string& name)
{
    files_.push_back(name);
    writing_.run(
        [image = std::move(codes), path = settings_.folder / name] { image::write_codes(image, path); });
}

std::vector<std::string> ShotRenderer::finish()
{
    writing_.wait();
    return files_;
}

} // namespace lambent::report
