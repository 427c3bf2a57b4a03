// Writes the albedo table as C++ to standard output; run by the build.
#include "environment/albedo_table.h"
#include "environment/albedo_quadrature.h"

#include <cstdio>

using namespace lambent::environment;

int main()
{
    constexpr int n = lambent::environment::albedo_table_size;
    std::puts("#include \"environment/albedo_table.h\"\n\n"
              "const float lambent::environment::albedo_table[] = {");
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const double x = column / (n - 1.0), roughness = row / (n - 1.0);
            const auto pair =
                directional_albedo(std::max(x * x, least_cosine), std::max(roughness * roughness, least_alpha));
            std::printf("%#.9gf, %#.9gf,\n", pair.x, pair.y);
        }
    std::puts("};");
}
