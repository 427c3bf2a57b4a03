#include "draw/layer_list.h"

namespace lambent::draw {

std::vector<LayerSource> layer_sources(Model model)
{
    using Kind = Layer::Kind;
    const bool phong = model == Model::phong;
    std::vector<LayerSource> sources = {
        {phong ? "diffuse" : "base_color", Kind::color, base_r, Reading::three},
        {"specular", Kind::color, specular_r, Reading::three},
        {phong ? "exponent" : "alpha", phong ? Kind::exponent : Kind::scalar, gloss, Reading::one},
        {"normal", Kind::normal, shading_x, Reading::three},
        {"depth", Kind::depth, depth, Reading::one},
        {"occlusion", Kind::scalar, occlusion, Reading::one},
        {"mip_level", Kind::scalar, middle_level, Reading::one},
        {"irradiance", Kind::irradiance, irradiance_r, Reading::three},
        {"light_emitted", Kind::light, emitted_r, Reading::three},
        {"light_direct", Kind::light, direct_r, Reading::three},
        {"light_ambient", Kind::light, ambient_r, Reading::three},
        {"light_specular", Kind::light, reflected_r, Reading::three},
    };
    if (!phong)
        sources.insert(sources.begin() + 3, {{"roughness", Kind::scalar, gloss, Reading::root}, // of alpha
                                             {"metalness", Kind::scalar, metalness, Reading::one}});
    return sources;
}

} // namespace lambent::draw
