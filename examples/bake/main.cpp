// Bakes a panorama, or a built-in environment, into a KTX 2 cube map of specular light by roughness.
#include <lambent/bake.h>

#include <cstdio>
#include <exception>
#include <string>

int main(int count, char** words)
try {
    const std::string from = count > 1 ? words[1] : "kitchen", to = count > 2 ? words[2] : "specular.ktx2";
    const bool is_file = from.find('.') != std::string::npos;
    const auto panorama = is_file ? lambent::Panorama::load(from) : lambent::Panorama::builtin(from);
    for (const std::string& warning : panorama.warnings())
        std::fprintf(stderr, "warning: %s\n", warning.c_str());

    const lambent::Specular specular = lambent::bake_specular(panorama, {.size = 64});
    for (const lambent::SpecularLevel& level : specular.levels)
        std::printf("roughness %.3f  error %.4f\n", level.perceptual_roughness, level.error);
    lambent::write_ktx2(specular.cube, to);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
