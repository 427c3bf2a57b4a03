#include "draw/layer_list.h"

namespace lambent::draw {

std::vector<LayerSource> layer_sources(Model model)
{
    using Kind = Layer::Kind;
    const bool phong = model == Model::phong;
    std::vector<LayerSource> sources = {
        {phong ? "diffuse" : "base_color", Kind::color, base_r, true},
        {"specular", Kind::color, specular_r, true},
        {phong ? "exponent" : "alpha", phong ? Kind::exponent : Kind::scalar, gloss, false},
        {"normal", Kind::normal, shading_x, true},
        {"depth", Kind::depth, depth, false},
        {"occlusion", Kind::scalar, occlusion, false},
        {"irradiance", Kind::irradiance, irradiance_r, true},
        {"light_emitted", Kind::light, emitted_r, true},
        {"light_direct", Kind::light, direct_r, true},
        {"light_ambient", Kind::light, ambient_r, true},
        {"light_specular", Kind::light, reflected_r, true},
    };
    if (!phong)
        sources.insert(sources.begin() + 3, {"metalness", Kind::scalar, metalness, false});
    return sources;
}

} // namespace lambent::draw
