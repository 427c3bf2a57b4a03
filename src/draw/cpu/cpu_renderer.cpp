#include "draw/cpu/cpu_renderer.h"

#include "base/text.h"
#include "draw/cpu/tile.h"

#include <hwy/targets.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>
#include <optional>

namespace lambent::draw {
namespace {

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
    explicit CpuRenderer(const scene::Scene& scene) : first_(scene), scene_(&scene) {}

    Frame draw(const environment::Environment* environment, const Settings& settings,
               const std::function<void(float)>& progress) override
    {
        prepare(settings.texel_transfer);
        const PreparedPicture prepared(scene_->lights, environment, settings);
        return draw_tiles({*prepared_, settings, prepared}, progress);
    }

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

private:
    void prepare(TexelTransfer transfer)
    {
        if (!prepared_ || prepared_transfer_ != transfer) {
            prepared_.reset();
            prepared_.emplace(first_, *scene_, transfer);
            prepared_transfer_ = transfer;
        } else if (stale_) {
            prepared_->pose(*scene_);
        }
        stale_ = false;
    }

    static Frame draw_tiles(const Picture& picture, const std::function<void(float)>& report)
    {
        const Settings& settings = picture.settings;
        Frame frame = blank_frame(settings);
        constexpr int size = TileDrawer::largest_size;
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

    const scene::Scene& first_; ///< has the images
    const scene::Scene* scene_; ///< as it is drawn
    bool stale_ = false;        ///< whether another was prepared
    std::optional<PreparedScene> prepared_;
    TexelTransfer prepared_transfer_ = TexelTransfer::srgb;
};

} // namespace

std::unique_ptr<Renderer> make_cpu_renderer(const scene::Scene& scene)
{
    return std::make_unique<CpuRenderer>(scene);
}

} // namespace lambent::draw
