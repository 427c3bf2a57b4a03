#include "draw/vulkan/background_on_device.h"

#include <algorithm>
#include <cmath>

namespace lambent::draw {
namespace {

using namespace gpu_layout;

// For each of the two levels that are read: the weight of the lamps that are missing in it, and its angular variance.
vec4 blur_of(const environment::Environment& e, float level)
{
    const float clamped = std::min(level, static_cast<float>(e.chain.levels - 1)), fine = std::floor(clamped);
    vec4 blur(0.0f);
    for (int i = 0; i < 2; ++i) {
        const int whole = static_cast<int>(fine) + i;
        blur[2 * i] = whole <= e.lamps.last_level ? 0.0f : i == 0 ? 1.0f - (clamped - fine) : clamped - fine;
        blur[2 * i + 1] = environment::level_variance(e.chain, whole);
    }
    return blur;
}

} // namespace

bool describe_background(const vulkan::Device& device, const PreparedPicture& picture,
                         EnvironmentOnDevice& on_device, PictureRecord& record)
{
    const Background& background = picture.settings.background;
    const environment::Environment* const environment = picture.light.environment;
    record.background = vec4(background.color, picture.background_level);
    record.behind.x = background.kind == Background::Kind::color ? background_color : background_none;
    if (environment &&
        (background.kind == Background::Kind::environment || background.kind == Background::Kind::blurred)) {
        record.behind.x = picture.background_level < 0.0f ? background_panorama : background_blurred;
        record.blur = blur_of(*environment, std::max(picture.background_level, 0.0f));
    }
    if (record.behind.x != background_panorama)
        return record.behind.x != background_none;
    const environment::Panorama& panorama = environment->panorama;
    const VkDeviceAddress address = on_device.panorama(device, panorama).address();
    record.addresses.z = static_cast<uint>(address);
    record.addresses.w = static_cast<uint>(address >> 32);
    record.behind.y = panorama.width;
    record.behind.z = panorama.height;
    record.panorama.x = panorama.scale;
    return true;
}

} // namespace lambent::draw
