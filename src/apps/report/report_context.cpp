#include "apps/report/report_context.h"

#include "base/text.h"

namespace lambent::report {

PagePicture ReportContext::proven(const Shot& shot, const std::string& figure)
{
    PagePicture picture = renderer.picture(shot);
    if (!references)
        return picture;
    Proof proof = renderer.prove(shot);
    picture.numbers.push_back({"error", percent(proof.error)});
    picture.numbers.push_back({"reference's noise", noise_text(proof.noise)});
    entries.push_back({figure, std::move(proof)});
    return picture;
}

double mean_on_surfaces(const image::RadianceImage& light)
{
    double sum = 0.0, covered = 0.0;
    for (std::size_t i = 0; i < light.values.size(); i += 4) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            sum += static_cast<double>(light.values[i + channel]) / 3.0;
        covered += static_cast<double>(light.values[i + 3]);
    }
    return sum / covered;
}

Matrix transposed(const Matrix& matrix)
{
    Matrix turned{matrix.columns, matrix.rows, {}};
    turned.pictures.reserve(matrix.pictures.size());
    for (std::size_t column = 0; column < matrix.columns.size(); ++column)
        for (std::size_t row = 0; row < matrix.rows.size(); ++row)
            turned.pictures.push_back(matrix.pictures.at(row * matrix.columns.size() + column));
    return turned;
}

Shot reflecting(int exponent, const std::string& levels)
{
    return {text("specular-", exponent, levels == "report" ? "-report" : ""),
            text("painted --model phong --kd 0.02,0.02,0.02 --ks 0.9,0.9,0.9 --alpha ", exponent,
                 " --mip-level ", levels, " --camera 240,14,2.6 --fov 34"),
            text("\u03b1 = ", exponent),
            text("A sphere on a plane, both reflecting with exponent ", exponent,
                 levels == "report" ? ", by the report's levels" : ", by matched levels")};
}

} // namespace lambent::report
