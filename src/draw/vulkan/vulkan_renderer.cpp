#include "draw/vulkan/vulkan_renderer.h"

#include "base/text.h"
#include "draw/cpu/cpu_renderer.h"
#include "draw/vulkan/light_stage.h"

#include <map>
#include <mutex>

namespace lambent::draw {
namespace {

// One queue, one batch of fragments at a time; the processor finds the next ones meanwhile.
class DeviceLighter : public FragmentLighter {
public:
    DeviceLighter(const vulkan::Device& device, const vulkan::PipelineCache& cache,
                  const LightContext& context, std::span<const LightSource> lights)
        : stage_(device, cache, context, lights)
    {
    }

    void light(Fragments& fragments) override
    {
        const std::lock_guard lock(mutex_);
        stage_.light(fragments);
        for (const auto& [name, milliseconds] : stage_.laps()) {
            if (!times_.contains(name))
                order_.push_back(name);
            times_[name] += milliseconds;
        }
    }

    std::vector<std::pair<std::string, double>> passes() const override
    {
        std::vector<std::pair<std::string, double>> passes;
        for (const std::string& name : order_)
            passes.emplace_back(name, times_.at(name));
        return passes;
    }

private:
    std::mutex mutex_;
    LightStage stage_;
    std::vector<std::string> order_;
    std::map<std::string, double> times_;
};

class Lit : public VulkanRenderer {
public:
    Lit(const scene::Scene& scene, const VulkanOptions& options)
        : instance_(options.validation),
          device_(instance_,
                  vulkan::choose(instance_.devices(),
                                 options.software ? vulkan::Choice::any : vulkan::Choice::hardware)),
          cache_(device_, options.cache_folder.empty() ? std::filesystem::path()
                                                       : options.cache_folder / "shaders.bin"),
          renderer_(make_cpu_renderer(
              scene, [this](const LightContext& context, std::span<const LightSource> lights) {
                  return std::make_unique<DeviceLighter>(device_, cache_, context, lights);
              }))
    {
    }

    Frame draw(const environment::Environment* environment, const Settings& settings,
               const std::function<void(float)>& progress) override
    {
        Frame frame = renderer_->draw(environment, settings, progress);
        cache_.keep();
        return frame;
    }

    Device device() const override
    {
        return {"vulkan", text(device_.name(), "; surfaces by ", renderer_->device().description)};
    }

    std::vector<std::string> complaints() const override { return instance_.complaints(); }

private:
    vulkan::Instance instance_;
    vulkan::Device device_;
    vulkan::PipelineCache cache_;
    std::unique_ptr<Renderer> renderer_;
};

} // namespace

std::unique_ptr<VulkanRenderer> make_vulkan_renderer(const scene::Scene& scene, const VulkanOptions& options)
{
    return std::make_unique<Lit>(scene, options);
}

} // namespace lambent::draw
