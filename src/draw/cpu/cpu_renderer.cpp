#include "draw/cpu/cpu_renderer.h"

#include "base/text.h"
#include "draw/cpu/full_light.h"
#include "draw/cpu/tile.h"
#include "draw/cpu/tiles.h"

#include <hwy/targets.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace lambent::draw {
namespace {

// Calls GoOn after every tile, one thread at a time. Tiles that finish after it returned false are reported too, so
// that the caller knows the final fraction.
class ProgressReporter {
public:
    ProgressReporter(const Drawing::GoOn& go_on, int done, int all) : go_on_(go_on), done_(done), all_(all) {}

    void step()
    {
        const std::lock_guard lock(mutex_);
        ++done_;
        if (go_on_ && !go_on_(fraction()))
            stopped_ = true;
    }

    // Asks in the middle of a part.
    void check()
    {
        const std::lock_guard lock(mutex_);
        if (go_on_ && !stopped_ && !go_on_(fraction()))
            stopped_ = true;
    }

    bool stopped() const { return stopped_; }
    int done() const { return done_; }

private:
    float fraction() const { return std::min(static_cast<float>(done_) / static_cast<float>(all_), 1.0f); }

    const Drawing::GoOn& go_on_;
    std::mutex mutex_;
    int done_, all_;
    std::atomic<bool> stopped_ = false;
};

class CpuRenderer : public Renderer {
public:
    explicit CpuRenderer(const scene::Scene& scene) : first_(scene), scene_(&scene) {}

    std::unique_ptr<Drawing> start(const environment::Environment* environment,
                                   const Settings& settings) override;

    void pose(const scene::Scene& scene) override
    {
        scene_ = &scene;
        stale_ = true;
    }

    Device device() const override
    {
        const std::int64_t targets = hwy::SupportedTargets() & HWY_TARGETS;
        const std::size_t allowed =
            tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
        const auto arena = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
        return {"cpu", text(hwy::TargetName(targets & -targets), ", ", std::min(allowed, arena), " threads")};
    }

    // The scene in its current pose, with textures for this transfer.
    const PreparedScene& prepared(TexelTransfer transfer)
    {
        if (!prepared_ || prepared_transfer_ != transfer) {
            prepared_.reset();
            prepared_.emplace(first_, *scene_, transfer);
            prepared_transfer_ = transfer;
        } else if (stale_) {
            prepared_->pose(*scene_);
        }
        stale_ = false;
        return *prepared_;
    }

    const scene::Scene& scene() const { return *scene_; }

    // The cache of the light of a picture that was drawn, for pictures that keep it; null: none yet.
    const std::shared_ptr<const WorldCache>& known_light() const { return known_light_; }
    void remember(std::shared_ptr<const WorldCache> light) { known_light_ = std::move(light); }

private:
    const scene::Scene& first_; ///< holds the images
    const scene::Scene* scene_; ///< the current pose
    bool stale_ = false;        ///< whether `prepared_` has another pose
    std::optional<PreparedScene> prepared_;
    TexelTransfer prepared_transfer_ = TexelTransfer::srgb;
    std::shared_ptr<const WorldCache> known_light_;
};

class CpuDrawing : public Drawing {
public:
    CpuDrawing(CpuRenderer& renderer, const environment::Environment* environment, const Settings& settings)
        : renderer_(renderer), settings_(settings),
          prepared_(renderer.scene().lights, environment, settings_),
          frame_(blank_frame(settings_, renderer.scene())), tiles_(settings_.width, settings_.height)
    {
    }

    bool advance(const GoOn& go_on) override
    {
        const PreparedScene& scene = renderer_.prepared(settings_.texel_transfer);
        if (settings_.bounces > 0 && !full_light_)
            full_light_ = make_full_light(scene);
        const PictureContext picture = picture_context(scene, settings_, prepared_);
        ProgressReporter reporter(go_on, done_,
                                  tiles_.count() * (1 + (full_light_ ? full_light_->stages() : 0)));
        const FullLight::ForTiles for_tiles = [&](Tiles& tiles, const std::function<void(int)>& visit) {
            tbb::parallel_for(0, tiles.count(), [&](int tile) {
                if (reporter.stopped() || tiles.is_done(tile))
                    return;
                visit(tile);
                tiles.set_done(tile);
                reporter.step();
            });
        };
        draw_tiles(picture, for_tiles);
        const std::function<void()> check = [&] { reporter.check(); };
        const bool complete =
            tiles_.all_done() && (!full_light_ || full_light_->advance({picture, for_tiles, check, frame_}));
        done_ = reporter.done();
        if (complete && full_light_ && full_light_->known())
            renderer_.remember(full_light_->known());
        return complete;
    }

    Frame take() override
    {
        if (full_light_)
            full_light_->apply(frame_, {});
        return std::move(frame_);
    }

    void refine(int passes) override
    {
        if (!full_light_)
            Drawing::refine(passes);
        full_light_->refine(passes);
    }

    Frame picture(const Check& check) const override
    {
        if (!full_light_)
            return Drawing::picture(check);
        Frame copy = frame_;
        full_light_->apply(copy, check);
        return copy;
    }

private:
    std::unique_ptr<FullLight> make_full_light(const PreparedScene& scene) const
    {
        const view::PixelArea covered = view::covered_area(scene.visibility().bounds(), prepared_.rays,
                                                           settings_.width, settings_.height);
        const bool keeps = settings_.keeps_known_light && settings_.bounces > 1;
        return std::make_unique<FullLight>(settings_, covered, !prepared_.lights.empty(),
                                           keeps ? renderer_.known_light() : nullptr);
    }

    // Draws the picture without shadows.
    void draw_tiles(const PictureContext& picture, const FullLight::ForTiles& for_tiles)
    {
        tbb::enumerable_thread_specific<TileDrawer> drawers([&] { return TileDrawer(picture); });
        for_tiles(tiles_, [&](int tile) {
            drawers.local().draw(tiles_.area(tile), frame_, full_light_ ? &full_light_->sums() : nullptr);
        });
    }

    CpuRenderer& renderer_;
    const Settings settings_;
    const PreparedPicture prepared_;
    Frame frame_; ///< without shadows
    Tiles tiles_;
    std::unique_ptr<FullLight> full_light_; ///< null without bounces
    int done_ = 0;                          ///< tiles, over all stages
};

std::unique_ptr<Drawing> CpuRenderer::start(const environment::Environment* environment,
                                            const Settings& settings)
{
    return std::make_unique<CpuDrawing>(*this, environment, settings);
}

} // namespace

std::unique_ptr<Renderer> make_cpu_renderer(const scene::Scene& scene)
{
    return std::make_unique<CpuRenderer>(scene);
}

} // namespace lambent::draw
