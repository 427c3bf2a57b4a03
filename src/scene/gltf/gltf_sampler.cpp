#include "scene/gltf/gltf_sampler.h"

#include "scene/index.h"

namespace lambent::scene {
namespace {

Wrap read_wrap(const Document& document, int code, int sampler)
{
    switch (code) {
    case gltf::Wrapping::repeat:
        return Wrap::repeat;
    case gltf::Wrapping::mirrored_repeat:
        return Wrap::mirrored_repeat;
    case gltf::Wrapping::clamp_to_edge:
        return Wrap::clamp_to_edge;
    default:
        document.fail("sampler ", sampler, ": wrap mode ", code, " is not defined by glTF");
    }
}

void read_magnification(const Document& document, int code, int index, Sampler& sampler)
{
    switch (code) {
    case gltf::none:
    case gltf::Filter::linear:
        break;
    case gltf::Filter::nearest:
        sampler.magnify_nearest = true;
        break;
    default:
        document.fail("sampler ", index, ": magFilter ", code, " is not defined by glTF");
    }
}

void read_minification(const Document& document, int code, int index, Sampler& sampler)
{
    switch (code) {
    case gltf::none:
    case gltf::Filter::linear_mipmap_linear:
        break;
    case gltf::Filter::linear_mipmap_nearest:
    case gltf::Filter::nearest_mipmap_nearest:
    case gltf::Filter::nearest_mipmap_linear:
        sampler.minify_nearest = code != gltf::Filter::linear_mipmap_nearest;
        sampler.nearest_mipmap = code != gltf::Filter::nearest_mipmap_linear;
        break;
    case gltf::Filter::linear:
    case gltf::Filter::nearest:
        sampler.minify_nearest = code == gltf::Filter::nearest;
        sampler.mipmapped = false;
        break;
    default:
        document.fail("sampler ", index, ": minFilter ", code, " is not defined by glTF");
    }
}

} // namespace

Sampler read_sampler(const Document& document, int index, Losses& losses)
{
    const gltf::Sampler& source = document.model.samplers[at(index)];
    Sampler sampler;
    losses.spare("repeat is used", [&] { sampler.wrap_u = read_wrap(document, source.wrap_s, index); });
    losses.spare("repeat is used", [&] { sampler.wrap_v = read_wrap(document, source.wrap_t, index); });
    losses.spare("linear is used", [&] { read_magnification(document, source.mag_filter, index, sampler); });
    losses.spare("linear is used", [&] { read_minification(document, source.min_filter, index, sampler); });
    return sampler;
}

} // namespace lambent::scene
