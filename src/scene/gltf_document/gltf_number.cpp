#include "scene/gltf_document/gltf_number.h"

#include "base/text.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace lambent::scene {

std::string read_whole(const nlohmann::json& value, double most, std::string_view name, std::uint64_t& whole)
{
    const double number = value.is_number() ? value.get<double>() : -1.0;
    if (!(number >= 0.0 && number <= most) || number != std::floor(number))
        return text(name, " is not a whole number from 0 to ", static_cast<std::int64_t>(most));
    whole = static_cast<std::uint64_t>(number);
    return {};
}

std::string check_number(const nlohmann::json& value, std::string_view name)
{
    if (!value.is_number())
        return text(name, " is not a number");
    if (!(std::abs(value.get<double>()) <= static_cast<double>(std::numeric_limits<float>::max())))
        return text(name, " is too large");
    return {};
}

std::string check_numbers(const nlohmann::json& array, const Property& property)
{
    for (const nlohmann::json& number : array)
        if (std::string reason = check_number(number, property.name); !reason.empty())
            return reason;
    if (property.length != 0 && array.size() != property.length)
        return text(property.name, " has ", array.size(), " numbers, not ", property.length);
    return {};
}

} // namespace lambent::scene
