#include "scene/gltf/gltf_texture.h"

#include "scene/index.h"

#include <cmath>

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

// T * R * S, where R rotates by -rotation in the usual notation, since v points down. The listing in the extension's
// text has the other sign; its example and the implementations agree on this one (KhronosGroup/glTF issue 1563).
// [KHR_texture_transform]
glm::mat3 transform_of(const gltf::TextureTransform& transform)
{
    const auto& [offset, scale, angle, tex_coord] = transform;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    // Columns: the images of the u axis, the v axis and the origin.
    return {glm::vec3(c * scale[0], -s * scale[0], 0.0), glm::vec3(s * scale[1], c * scale[1], 0.0),
            glm::vec3(offset[0], offset[1], 1.0)};
}

} // namespace

TextureUse TextureReader::read(const gltf::TextureInfo& info, const std::string& where, std::string_view slot)
{
    TextureUse use;
    const bool found = losses_.spare("the texture is left out", [&] { use = find(info, where, slot); });
    // GCC 12 does not keep the default `use` where find() throws.
    return found ? use : TextureUse();
}

TextureUse TextureReader::find(const gltf::TextureInfo& info, const std::string& where, std::string_view slot)
{
    TextureUse use;
    const auto& textures = document_.model.textures;
    if (at(info.index) >= textures.size())
        document_.fail(where, ", ", slot, ": texture ", info.index, " does not exist");
    const gltf::Texture& texture = textures[at(info.index)];
    if (texture.is_broken)
        throw told_already();
    use.sampler = find_sampler(texture.sampler, where);
    use.texcoord = info.tex_coord;
    if (info.transform) {
        use.transform = transform_of(*info.transform);
        use.texcoord = info.transform->tex_coord.value_or(info.tex_coord);
    }
    if (texture.source < 0) {
        losses_.add(text(document_.file, ": ", where, ": ", slot, ": texture ", info.index,
                         " has no PNG or JPEG image: left out"));
        return {};
    }
    if (at(texture.source) >= document_.model.images.size())
        document_.fail("texture ", info.index, ": image ", texture.source, " does not exist");
    use.image = scene_image(texture.source);
    return use;
}

Sampler TextureReader::find_sampler(int index, const std::string& where)
{
    if (index < 0)
        return {};
    if (at(index) < document_.model.samplers.size())
        return read_sampler(document_, index, losses_);
    losses_.add(text(document_.file, ": ", where, ": sampler ", index,
                     " does not exist: the default sampler is used"));
    return {};
}

// Images with the same source become one.
int TextureReader::scene_image(int image)
{
    const gltf::Image& source = document_.model.images[at(image)];
    const auto [found, is_new] =
        image_index_.try_emplace({source.buffer_view, source.uri}, static_cast<int>(images_.size()));
    if (is_new)
        images_.push_back(image);
    return found->second;
}

} // namespace lambent::scene
