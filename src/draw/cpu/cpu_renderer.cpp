#include "draw/cpu/cpu_renderer.h"

#include "base/text.h"
#include "draw/cpu/tile.h"

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

// The tiles of a picture, and which of them are drawn.
class Tiles {
public:
    Tiles(int width, int height)
        : width_(width), height_(height), columns_((width + size - 1) / size),
          done_(static_cast<std::size_t>(columns_ * ((height + size - 1) / size)), 0)
    {
    }

    int count() const { return static_cast<int>(done_.size()); }

    TileArea area(int tile) const
    {
        const int x = tile % columns_ * size, y = tile / columns_ * size;
        return {x, y, std::min(size, width_ - x), std::min(size, height_ - y)};
    }

    // Each tile is accessed by one thread only.
    bool is_done(int tile) const { return done_[static_cast<std::size_t>(tile)] != 0; }
    void set_done(int tile) { done_[static_cast<std::size_t>(tile)] = 1; }

    int done_count() const { return static_cast<int>(std::count(done_.begin(), done_.end(), char(1))); }

private:
    static constexpr int size = TileDrawer::largest_size;
    int width_, height_, columns_;
    std::vector<char> done_;
};

// Calls GoOn after every tile, one thread at a time. Tiles that finish after it returned false are reported too, so
// that the caller knows the final fraction.
class ProgressReporter {
public:
    ProgressReporter(const Drawing::GoOn& go_on, int done, int all) : go_on_(go_on), done_(done), all_(all) {}

    void step()
    {
        if (!go_on_)
            return;
        const std::lock_guard lock(mutex_);
        ++done_;
        if (!go_on_(static_cast<float>(done_) / static_cast<float>(all_)))
            stopped_ = true;
    }

    bool stopped() const { return stopped_; }

private:
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

private:
    const scene::Scene& first_; ///< holds the images
    const scene::Scene* scene_; ///< the current pose
    bool stale_ = false;        ///< whether `prepared_` has another pose
    std::optional<PreparedScene> prepared_;
    TexelTransfer prepared_transfer_ = TexelTransfer::srgb;
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
        const PictureContext picture =
            picture_context(renderer_.prepared(settings_.texel_transfer), settings_, prepared_);
        ProgressReporter reporter(go_on, tiles_.done_count(), tiles_.count());
        tbb::enumerable_thread_specific<TileDrawer> drawers([&] { return TileDrawer(picture); });
        tbb::parallel_for(0, tiles_.count(), [&](int tile) {
            if (reporter.stopped() || tiles_.is_done(tile))
                return;
            drawers.local().draw(tiles_.area(tile), frame_);
            tiles_.set_done(tile);
            reporter.step();
        });
        return tiles_.done_count() == tiles_.count();
    }

    Frame take() override { return std::move(frame_); }

private:
    CpuRenderer& renderer_;
    const Settings settings_;
    const PreparedPicture prepared_;
    Frame frame_;
    Tiles tiles_;
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
