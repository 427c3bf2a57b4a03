#include "environment/builtin/builtin.h"

#include "base/closest.h"
#include "base/error.h"
#include "base/text.h"
#include "environment/builtin/kitchen.h"
#include "environment/sky/sky.h"
#include "environment/builtin/studio.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace lambent::environment {
namespace {

constexpr std::array<std::string_view, 4> names = {"kitchen", "studio", "sky", "furnace"};

void check(bool in_range, const char* what, double value, const char* range)
{
    if (!in_range)
        throw Error(Failure::usage, text(what, " ", value, " is not ", range));
}

void check(const BuiltinOptions& o)
{
    const bool power_of_two = o.width > 0 && std::has_single_bit(static_cast<unsigned>(o.width));
    check(power_of_two && o.width >= 64 && o.width <= 8192, "panorama width", o.width,
          "a power of two from 64 to 8192");
    check(std::isfinite(o.sun_azimuth), "sun azimuth", static_cast<double>(o.sun_azimuth), "finite");
    check(o.sun_elevation >= -0.1f && o.sun_elevation <= 0.5f * std::numbers::pi_v<float>, "sun elevation",
          static_cast<double>(o.sun_elevation), "from -0.1 to pi/2 radians");
    check(o.turbidity >= 1.5f && o.turbidity <= 10.0f, "turbidity", static_cast<double>(o.turbidity),
          "from 1.5 to 10");
}

image::RadianceImage make_furnace(int width)
{
    image::RadianceImage panorama{width, width / 2, 3, {}};
    panorama.values.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(width / 2) * 3, 1.0f);
    return panorama;
}

} // namespace

std::span<const std::string_view> builtin_names()
{
    return names;
}

bool is_builtin(std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

image::RadianceImage make_builtin(std::string_view name, const BuiltinOptions& given)
{
    if (!is_builtin(name))
        throw Error(Failure::usage,
                    text("there is no built-in environment '", name, "'",
                         did_you_mean(name, std::vector<std::string>(names.begin(), names.end()))));
    BuiltinOptions options = given;
    if (options.width == 0)
        options.width = name == "kitchen" ? 2048 : 1024;
    check(options);
    if (name == "kitchen")
        return make_kitchen(options.width);
    if (name == "studio")
        return make_studio(options.width);
    if (name == "sky")
        return make_sky({options.width, options.sun_azimuth, options.sun_elevation, options.turbidity});
    return make_furnace(options.width);
}

} // namespace lambent::environment
