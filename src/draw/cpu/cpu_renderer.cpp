#include "draw/cpu/cpu_renderer.h"

#include "base/text.h"
#include "draw/cpu/layer_list.h"
#include "draw/cpu/tile.h"
#include "equations/in_double.h"

#include <hwy/targets.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

namespace lambent::draw {
namespace {

image::RadianceImage blank(int width, int height)
{
    image::RadianceImage image{width, height, 4, {}};
    image.values.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 0.0f);
    return image;
}

Frame blank_frame(const Settings& settings)
{
    Frame frame;
    frame.radiance = blank(settings.width, settings.height);
    if (!settings.layers)
        return frame;
    for (const LayerSource& source : layer_sources(settings.model))
        frame.layers.push_back({source.name, source.kind, blank(settings.width, settings.height)});
    frame.layers.push_back({background_layer, Layer::Kind::light, blank(settings.width, settings.height)});
    return frame;
}

// N places in the unit square with different rows and columns each. [Hammersley 1960]
std::vector<glm::vec2> subpixel_places(int count)
{
    std::vector<glm::vec2> places;
    places.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        places.emplace_back((static_cast<float>(i) + 0.5f) / static_cast<float>(count),
                            std::fmod(radical_inverse(static_cast<unsigned>(i)) + 0.5 / count, 1.0));
    return places;
}

// Surfaces that bend by 30 degrees between pixels are edges; looks share a shading point within 15 degrees. Who asks for
// many samples wants exact pictures: a mirrored picture that bends inside a pixel is then lit place by place.
Edges edges_of(const Settings& settings)
{
    constexpr int many_samples = 256, places_of_many = 16;
    if (settings.samples < many_samples)
        return {subpixel_places(settings.edge_samples), 0.866f, 0.966f, 1.0f};
    const int count = settings.edge_samples > 1 ? std::max(settings.edge_samples, places_of_many) : 1;
    return {subpixel_places(count), 0.995f, 2.0f, 1.0f / std::sqrt(static_cast<float>(count))};
}

double background_level(const environment::Environment& environment, const Settings& settings,
                        const RayMap& rays)
{
    const double level_one = environment::level_one_deviation(environment.chain);
    // A pixel of a wide view of a large panorama covers many texels.
    const double pixel = glm::length(rays.direction_dx);
    const double texel = 6.283185307179586 / environment.panorama.width;
    const bool blurred = settings.background.kind == Background::Kind::blurred;
    if (!blurred && pixel < 2.0 * texel)
        return -1.0;
    // A Gaussian of the lobe's width: for a view along the normal GGX's mirrored lobe has about 2 alpha.
    const double deviation = blurred ? std::pow(settings.background.roughness, 2) : 0.0;
    return in_double::level_of_variance((deviation * deviation + pixel * pixel / 12.0) /
                                        (level_one * level_one));
}

// Calls back with the done fraction, one thread at a time.
class Progress {
public:
    Progress(const std::function<void(float)>& report, int all) : report_(report), all_(all) {}

    void step()
    {
        if (!report_)
            return;
        const std::lock_guard lock(mutex_);
        report_(static_cast<float>(++done_) / static_cast<float>(all_));
    }

private:
    const std::function<void(float)>& report_;
    std::mutex mutex_;
    int done_ = 0, all_;
};

class CpuRenderer : public Renderer {
public:
    explicit CpuRenderer(const scene::Scene& scene, MakeLighter make_lighter = {})
        : scene_(scene), make_lighter_(std::move(make_lighter))
    {
    }

    Frame draw(const environment::Environment* environment, const Settings& settings,
               const std::function<void(float)>& progress) override
    {
        prepare(settings.texel_transfer);
        const bool as_report = settings.mip_level == MipLevel::report;
        const SampleTables tables =
            make_sample_tables(settings.samples, as_report ? LobePoints::hammersley : LobePoints::spiral);
        std::vector<environment::Panorama> mips;
        if (environment && settings.model == Model::phong && as_report)
            mips = environment::mip_chain(environment->panorama);
        Picture picture{*prepared_, settings, {}, {}, {}, {}, -1.0f, nullptr};
        picture.rays = ray_map(settings.camera, settings.width, settings.height);
        picture.lights = light_sources(scene_.lights, settings.lights);
        picture.edges = edges_of(settings);
        picture.light.model = settings.model;
        picture.light.mip_level = settings.mip_level;
        picture.light.energy_compensation = settings.energy_compensation;
        picture.light.ambient_brightness = settings.ambient_brightness;
        picture.light.environment = environment;
        picture.light.mip_chain = &mips;
        picture.light.across = settings.camera.right;
        picture.light.rotation_cosine = std::cos(settings.environment_rotation);
        picture.light.rotation_sine = std::sin(settings.environment_rotation);
        picture.light.tables = &tables;
        if (environment)
            picture.background_level =
                static_cast<float>(background_level(*environment, settings, picture.rays));
        const std::unique_ptr<FragmentLighter> lighter =
            make_lighter_ ? make_lighter_(picture.light, picture.lights) : nullptr;
        picture.lighter = lighter.get();
        Frame frame = draw_tiles(picture, progress);
        if (lighter)
            frame.passes = lighter->passes();
        return frame;
    }

    Device device() const override
    {
        const std::int64_t targets = hwy::SupportedTargets() & HWY_TARGETS;
        const std::size_t allowed =
            tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
        const auto arena = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
        return {"cpu", text(hwy::TargetName(targets & -targets), ", ", std::min(allowed, arena), " threads")};
    }

private:
    void prepare(TexelTransfer transfer)
    {
        if (prepared_ && prepared_transfer_ == transfer)
            return;
        prepared_.reset();
        prepared_.emplace(scene_, transfer);
        prepared_transfer_ = transfer;
    }

    static Frame draw_tiles(const Picture& picture, const std::function<void(float)>& report)
    {
        const Settings& settings = picture.settings;
        Frame frame = blank_frame(settings);
        const int size = picture.lighter ? TileDrawer::largest_size : TileDrawer::usual_size;
        const int columns = (settings.width + size - 1) / size, rows = (settings.height + size - 1) / size;
        Progress progress(report, columns * rows);
        tbb::enumerable_thread_specific<TileDrawer> drawers([&] { return TileDrawer(picture); });
        tbb::parallel_for(0, columns * rows, [&](int tile) {
            const int x = tile % columns * size, y = tile / columns * size;
            drawers.local().draw(
                {x, y, std::min(size, settings.width - x), std::min(size, settings.height - y)}, frame);
            progress.step();
        });
        return frame;
    }

    const scene::Scene& scene_;
    MakeLighter make_lighter_; ///< empty: the processor
    std::optional<PreparedScene> prepared_;
    TexelTransfer prepared_transfer_ = TexelTransfer::srgb;
};

} // namespace

std::unique_ptr<Renderer> make_cpu_renderer(const scene::Scene& scene)
{
    return std::make_unique<CpuRenderer>(scene);
}

std::unique_ptr<Renderer> make_cpu_renderer(const scene::Scene& scene, MakeLighter make_lighter)
{
    return std::make_unique<CpuRenderer>(scene, std::move(make_lighter));
}

} // namespace lambent::draw
