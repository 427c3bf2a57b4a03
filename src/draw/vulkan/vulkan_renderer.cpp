#include "draw/vulkan/vulkan_renderer.h"

#include "draw/vulkan/picture_passes.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace lambent::draw {
namespace {

// A picture drawn in tiles from the top left, held in host memory.
struct PartialPicture {
    PartialPicture(const scene::Scene& scene, const environment::Environment* environment,
                   const Settings& given)
        : settings(given), prepared(scene.lights, environment, settings), frame(blank_frame(settings, scene))
    {
    }

    bool is_whole() const { return y >= settings.height; }

    PictureArea next(const TileShape& shape) const
    {
        return {x, y, std::min(shape.width, settings.width - x), std::min(shape.height, settings.height - y)};
    }

    void set_done(const PictureArea& area)
    {
        x += area.width;
        if (x < settings.width)
            return;
        x = 0;
        y += area.height;
    }

    float done(const TileShape& shape) const
    {
        const float row = static_cast<float>(next(shape).height) * static_cast<float>(x) /
                          static_cast<float>(settings.width);
        return (static_cast<float>(y) + row) / static_cast<float>(settings.height);
    }

    const Settings settings;
    const PreparedPicture prepared;
    Frame frame; ///< with the durations of all passes so far
    int x = 0, y = 0;
};

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

    std::unique_ptr<Drawing> start(const environment::Environment* environment,
                                   const Settings& settings) override;

    // The picture's data on the device are freed at the end of each call, because the picture may never be continued.
    bool advance(PartialPicture& picture, const Drawing::GoOn& go_on)
    {
        const Settings& settings = picture.settings;
        prepare_scene(settings.texel_transfer);
        const PassChoice choice = {static_cast<int>(look_places(picture.prepared.edges).size()),
                                   settings.model,
                                   settings.mip_level,
                                   settings.pipeline.has_value(),
                                   !first_.images.empty(),
                                   prepared_->has_layers(),
                                   prepared_->transparent()};
        const std::size_t layers = picture.frame.layers.size() + (prepared_->has_unlit() ? 1 : 0);
        const TileShape shape = tile_shape(device_, settings, choice.looks, static_cast<int>(layers));
        prepare_tile(shape);
        EnvironmentOnDevice& environment = environment_.of(device_, picture.prepared.light);
        PicturePasses passes({device_, *layout_, *prepared_, *tile_, environment, passes_for(choice)},
                             picture.prepared, bounds_);
        for (bool going = true; going && !picture.is_whole();) {
            const PictureArea area = picture.next(shape);
            passes.draw(area, picture.frame);
            picture.set_done(area);
            going = !go_on || go_on(picture.done(shape));
        }
        for (const auto& lap : passes.times())
            add_lap(lap, picture.frame.passes);
        cache_.keep();
        instance_.require_no_validation_messages();
        return picture.is_whole();
    }

    const scene::Scene& scene() const { return *scene_; }

    void pose(const scene::Scene& scene) override
    {
        scene_ = &scene;
        stale_ = true;
    }

    Device device() const override { return {"vulkan", device_.name()}; }

    std::vector<std::string> complaints() const override { return instance_.validation_messages(); }

private:
    // Scene, tile and passes are kept, because most pictures need those of the last picture or of the one before.
    void prepare_scene(TexelTransfer transfer)
    {
        if (stale_)
            bounds_ = scene::bounds(*scene_);
        if (!prepared_ || prepared_transfer_ != transfer) {
            prepared_.reset();
            prepared_.emplace(device_, first_, *scene_, transfer);
            prepared_transfer_ = transfer;
        } else if (stale_) {
            prepared_->pose(device_, *scene_);
        }
        stale_ = false;
    }

    // A larger tile is kept: pictures drawn in turn share one that covers them all, if memory allows it.
    void prepare_tile(const TileShape& shape)
    {
        if (tile_ && tile_->shape().covers(shape))
            return;
        const TileShape both = tile_ ? united(device_, shape, tile_->shape()) : shape;
        tile_.reset(); // frees its memory before the next is made
        tile_.emplace(device_, both);
    }

    Passes& passes_for(const PassChoice& choice)
    {
        const auto same = [&](const std::unique_ptr<Passes>& other) { return other->choice() == choice; };
        const auto found = std::find_if(passes_.begin(), passes_.end(), same);
        if (found != passes_.end()) {
            std::rotate(found, found + 1, passes_.end());
            return *passes_.back();
        }
        if (passes_.size() >= most_passes)
            passes_.erase(passes_.begin());
        return *passes_.emplace_back(std::make_unique<Passes>(cache_, *layout_, choice));
    }

    // Those of moving and of still pictures, for both models.
    static constexpr std::size_t most_passes = 4;

    const scene::Scene& first_; ///< holds the images
    const scene::Scene* scene_; ///< the current pose
    bool stale_ = false;        ///< whether `prepared_` has another pose
    scene::Bounds bounds_;
    vulkan::Instance instance_;
    vulkan::Device device_;
    vulkan::PipelineCache cache_;
    std::unique_ptr<vulkan::ShaderLayout> layout_;
    std::optional<SceneOnDevice> prepared_;
    TexelTransfer prepared_transfer_ = TexelTransfer::srgb;
    std::vector<std::unique_ptr<Passes>> passes_; ///< in the order of last use
    std::optional<TileOnDevice> tile_;
    KeptEnvironment environment_;
};

class DeviceDrawing : public Drawing {
public:
    DeviceDrawing(OnDevice& renderer, const environment::Environment* environment, const Settings& settings)
        : renderer_(renderer), picture_(renderer.scene(), environment, settings)
    {
    }

    bool advance(const GoOn& go_on) override { return renderer_.advance(picture_, go_on); }
    Frame take() override { return std::move(picture_.frame); }

private:
    OnDevice& renderer_;
    PartialPicture picture_;
};

std::unique_ptr<Drawing> OnDevice::start(const environment::Environment* environment,
                                         const Settings& settings)
{
    return std::make_unique<DeviceDrawing>(*this, environment, settings);
}

} // namespace

std::unique_ptr<VulkanRenderer> make_vulkan_renderer(const scene::Scene& scene, const VulkanOptions& options)
{
    return std::make_unique<OnDevice>(scene, options);
}

} // namespace lambent::draw
