#include "draw/vulkan/vulkan_renderer.h"

#include "draw/vulkan/picture_passes.h"

#include <algorithm>
#include <optional>

namespace lambent::draw {
namespace {

class OnDevice : public VulkanRenderer {
public:
    OnDevice(const scene::Scene& scene, const VulkanOptions& options)
        : first_(scene), scene_(&scene), bounds_(scene::bounds(scene)), instance_(options.validation),
          device_(instance_,
                  vulkan::choose(instance_.devices(),
                                 options.software ? vulkan::Choice::any : vulkan::Choice::hardware)),
          cache_(device_, options.cache_folder.empty() ? std::filesystem::path()
                                                       : options.cache_folder / "shaders.bin"),
          layout_(pass_layout(device_))
    {
    }

    Frame draw(const environment::Environment* environment, const Settings& settings,
               const std::function<void(float)>& progress) override
    {
        Frame frame = blank_frame(settings);
        const PreparedPicture picture(scene_->lights, environment, settings);
        prepare(picture, static_cast<int>(frame.layers.size()));
        PicturePasses passes({device_, *layout_, *prepared_, *tile_, *passes_}, picture, bounds_);
        const TileShape& shape = tile_->shape();
        for (int y = 0; y < settings.height; y += shape.height)
            for (int x = 0; x < settings.width; x += shape.width) {
                const int width = std::min(shape.width, settings.width - x),
                          height = std::min(shape.height, settings.height - y);
                passes.draw({x, y, width, height}, frame);
                if (progress)
                    progress(
                        (static_cast<float>(y) + static_cast<float>(x + width) * static_cast<float>(height) /
                                                     static_cast<float>(settings.width)) /
                        static_cast<float>(settings.height));
            }
        frame.passes = passes.times();
        cache_.keep();
        instance_.require_silence();
        return frame;
    }

    void pose(const scene::Scene& scene) override
    {
        scene_ = &scene;
        stale_ = true;
    }

    Device device() const override { return {"vulkan", device_.name()}; }

    std::vector<std::string> complaints() const override { return instance_.complaints(); }

private:
    // What is kept from picture to picture.
    void prepare(const PreparedPicture& picture, int layers)
    {
        const Settings& settings = picture.settings;
        if (stale_)
            bounds_ = scene::bounds(*scene_);
        if (!prepared_ || prepared_transfer_ != settings.texel_transfer) {
            prepared_.reset();
            prepared_.emplace(device_, first_, *scene_, settings.texel_transfer);
            prepared_transfer_ = settings.texel_transfer;
        } else if (stale_) {
            prepared_->pose(device_, *scene_);
        }
        stale_ = false;
        const PassChoice choice = {static_cast<int>(look_places(picture.edges).size()), settings.model,
                                   settings.mip_level, !first_.images.empty(), prepared_->transparent()};
        if (!passes_ || passes_->choice() != choice) {
            passes_.reset();
            passes_.emplace(cache_, *layout_, choice);
        }
        const TileShape shape = tile_shape(device_, settings, choice.looks, layers);
        if (!tile_ || tile_->shape() != shape) {
            tile_.reset();
            tile_.emplace(device_, shape);
        }
    }

    const scene::Scene& first_; ///< has the images
    const scene::Scene* scene_; ///< as it is drawn
    bool stale_ = false;        ///< whether another was prepared
    scene::Bounds bounds_;
    vulkan::Instance instance_;
    vulkan::Device device_;
    vulkan::PipelineCache cache_;
    std::unique_ptr<vulkan::ShaderLayout> layout_;
    std::optional<SceneOnDevice> prepared_;
    TexelTransfer prepared_transfer_ = TexelTransfer::srgb;
    std::optional<Passes> passes_;
    std::optional<TileOnDevice> tile_;
};

} // namespace

std::unique_ptr<VulkanRenderer> make_vulkan_renderer(const scene::Scene& scene, const VulkanOptions& options)
{
    return std::make_unique<OnDevice>(scene, options);
}

} // namespace lambent::draw
