#include "draw/layer_list.h"

namespace lambent::draw {

std::vector<LayerSource> layer_sources(Model model)
{
    using Kind = Layer::Kind;
    const bool phong = model == Model::phong;
    std::vector<LayerSource> sources = {
        {phong ? "diffuse" : "base_color", Kind::color, phong ? column_diffuse : column_base_color,
         Reading::three},
        {"specular", Kind::color, column_specular, Reading::three},
        {phong ? "exponent" : "alpha", phong ? Kind::exponent : Kind::scalar,
         phong ? column_exponent : column_alpha, Reading::one},
        {"normal", Kind::normal, column_shine, Reading::three},
        {"depth", Kind::depth, column_depth, Reading::one},
        {"occlusion", Kind::scalar, column_occlusion, Reading::one},
        {"mip_level", Kind::scalar, column_middle_level, Reading::one},
        {"irradiance", Kind::irradiance, column_irradiance, Reading::three},
        {"light_emitted", Kind::light, column_emissive, Reading::three},
        {"light_direct", Kind::light, column_direct, Reading::three},
        {"light_ambient", Kind::light, column_ambient, Reading::three},
        {"light_specular", Kind::light, column_reflected, Reading::three},
    };
    if (!phong)
        sources.insert(sources.begin() + 3,
                       {{"roughness", Kind::scalar, column_alpha, Reading::root}, // sqrt(alpha)
                        {"metalness", Kind::scalar, column_metallic, Reading::one}});
    return sources;
}

} // namespace lambent::draw
