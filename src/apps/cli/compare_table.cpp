#include "apps/cli/compare_table.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace lambent::cli {
namespace {

struct Row {
    const char* key;
    const char* name;
    double factor; ///< from the object's value to the printed one
    const char* unit;
    const char* none; ///< printed for a null
};

constexpr Row rows[] = {
    {"rmse", "RMSE", 1.0, "", "not finite"},
    {"relative_rmse", "relative RMSE", 100.0, " %", "infinite: the reference is black"},
    {"psnr", "PSNR", 1.0, " dB", "infinite: the pictures are equal"},
    {"flip", "FLIP", 1.0, "", "not finite"},
    {"max", "largest difference", 1.0, "", "not finite"},
};

std::string line(const char* name, const std::string& value)
{
    char words[160];
    std::snprintf(words, sizeof words, "%-20s%s\n", name, value.c_str());
    return words;
}

std::string value_of(const Row& row, const nlohmann::ordered_json& value)
{
    if (value.is_null())
        return row.none;
    char number[64];
    std::snprintf(number, sizeof number, "%.4g%s", row.factor * value.get<double>(), row.unit);
    return number;
}

} // namespace

std::string compare_table(const nlohmann::ordered_json& findings)
{
    const bool light = findings.at("kind") == "linear";
    char size[64];
    std::snprintf(size, sizeof size, "%dx%d, %s", findings.at("width").get<int>(),
                  findings.at("height").get<int>(), light ? "linear light" : "sRGB codes from 0 to 1");
    std::string table = line("pictures", size);
    if (findings.contains("covered"))
        table += line("pixels",
                      std::to_string(findings.at("covered").get<std::size_t>()) + " that surfaces cover");
    for (const Row& row : rows)
        table += line(row.name, value_of(row, findings.at(row.key)));
    if (light) {
        const auto& exposures = findings.at("flip_exposures");
        char words[96];
        std::snprintf(words, sizeof words, "HDR-FLIP, %d from %.3g to %.3g stops",
                      exposures.at("count").get<int>(), exposures.at("start").get<double>(),
                      exposures.at("stop").get<double>());
        table += line("exposures", words);
    }
    return table;
}

} // namespace lambent::cli
