// Writes the albedo table as C++ to standard output; run by the build.
#include "albedo/albedo_table.h"
#include "equations/in_double.h"

#include <cstdio>
#include <numbers>

namespace {

using namespace lambent::in_double;

constexpr int azimuths = 48, heights = 256;
constexpr double least_cosine = 1.0e-4, least_alpha = 1.0e-4;

// Both parts of the albedo: means over visible normals of the share that is not shadowed, times 1 - w (x) and times
// Schlick's weight w (y).
vec2 albedo(double NV, double alpha)
{
    const double sine = std::sqrt(1.0 - NV * NV);
    const vec3 stretched = stretched_view({sine, 0.0, NV}, vec2(alpha));
    double all = 0.0, grazing = 0.0;
    for (int j = 0; j < heights; ++j) {
        // Points are closer together towards the lobe's tail: even spacing misses 0.1 % of a smooth metal's lobe.
        const double left = 1.0 - (j + 0.5) / heights;
        const double height = 1.0 - left * left * left, weight = 3.0 * left * left;
        for (int i = 0; i < azimuths; ++i) {
            // Half the circle: the other half is its mirror image.
            const double phi = std::numbers::pi * (i + 0.5) / azimuths;
            const vec3 point(height, std::cos(phi), std::sin(phi));
            const VisibleFacet facet = sample_visible_ggx(stretched, vec2(alpha), point);
            const double VH = sine * facet.normal.x + NV * facet.normal.z;
            const double NL = 2.0 * VH * facet.normal.z - NV;
            if (NL <= 0.0)
                continue;
            const double kept = weight * shadowing_ggx(NL, NV, alpha);
            all += kept;
            grazing += kept * schlick_weight(VH);
        }
    }
    constexpr double count = azimuths * heights;
    return {(all - grazing) / count, grazing / count};
}

} // namespace

int main()
{
    constexpr int n = lambent::albedo_table_size;
    std::puts("#include \"albedo/albedo_table.h\"\n\n"
              "const float lambent::albedo_table[] = {");
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const double x = column / (n - 1.0), roughness = row / (n - 1.0);
            const vec2 pair =
                albedo(std::max(x * x, least_cosine), std::max(roughness * roughness, least_alpha));
            std::printf("%#.9gf, %#.9gf,\n", pair.x, pair.y);
        }
    std::puts("};");
}
