// The table of options: of all commands, and of `lambent serve`, `env` and `info`.
#include "apps/options/option_table.h"

#include "base/error.h"
#include "base/text.h"

#include <cmath>

namespace lambent::cli {
namespace {

// The value of --quiet and --verbose, which set the same member.
template <Verbosity verbosity>
constexpr Value<CommonOptions> sets{
    [](CommonOptions& a, const Option&, const std::string& word) {
        a.verbosity = word.empty() ? Verbosity::normal : verbosity;
    },
    [](const CommonOptions& a, const Option&) { return std::string(a.verbosity == verbosity ? "yes" : ""); }};

void set_width(EnvArguments& arguments, const Option& option, const std::string& word)
{
    const Size size = word.empty() ? Size{} : parse_size(word, dashed(option));
    if (size.width != 2 * size.height)
        throw Error(Failure::usage, text(dashed(option), ": ", word, " is not twice as wide as high"));
    arguments.builtin.width = size.width;
}

std::string width_word(const EnvArguments& arguments, const Option&)
{
    const int width = arguments.builtin.width;
    return width == 0 ? std::string() : size_word({width, width / 2});
}

void set_sun(EnvArguments& arguments, const Option& option, const std::string& word)
{
    environment::BuiltinOptions& options = arguments.builtin;
    const environment::BuiltinOptions usual;
    options.sun_azimuth = usual.sun_azimuth;
    options.sun_elevation = usual.sun_elevation;
    if (word.empty())
        return;
    const std::vector<double> sun = parse_list(word, {2, 2}, dashed(option));
    if (sun[1] < -5.7 || sun[1] > 90.0)
        throw Error(Failure::usage,
                    text(dashed(option), ": ", word, ": the elevation must be from -5.7 to 90 degrees"));
    options.sun_azimuth = turned(sun[0]);
    options.sun_elevation = radians(sun[1]);
}

std::string sun_word(const EnvArguments& arguments, const Option&)
{
    const environment::BuiltinOptions& options = arguments.builtin;
    const environment::BuiltinOptions usual;
    if (options.sun_azimuth == usual.sun_azimuth && options.sun_elevation == usual.sun_elevation)
        return {};
    return text(degrees_word(options.sun_azimuth), ",", degrees_word(options.sun_elevation));
}

} // namespace

template <>
const std::vector<Group<CommonOptions>>& groups<CommonOptions>()
{
    using R = Row<CommonOptions>;
    static const std::vector<Group<CommonOptions>> all = {
        {"Everywhere",
         command::all,
         {R("threads", "N", whole(1, 1024))
              .at([](auto& a) -> auto& { return a.threads; })
              .usually("one per processor")
              .says("Number of worker threads"),
          R("stats", "json", one_of("json"))
              .at([](auto& a) -> auto& { return a.stats_json; })
              .says("Print what was done and how long it took, as one JSON object",
                    "print one JSON object on standard output: milliseconds per stage and, on a Vulkan "
                    "device, per pass; backend, device, triangles, peak memory; not with `view` and `serve`"),
          R("strict")
              .at([](auto& a) -> auto& { return a.strict; })
              .says(
                  "Treat warnings about input files as errors, exit code 3",
                  "treat warnings about input files as errors, exit code 3; those about a device or an early "
                  "stop stay warnings"),
          R("quiet").at(sets<Verbosity::quiet>).says("No progress bar, no warnings"),
          R("verbose").at(sets<Verbosity::verbose>).says("Print what is being done")}}};
    return all;
}

template <>
const std::vector<Group<ServeArguments>>& groups<ServeArguments>()
{
    using R = Row<ServeArguments>;
    static const std::vector<Group<ServeArguments>> all = {
        {"Server",
         command::serve,
         {R("port", "P", whole(0, 65535), "8080")
              .at([](auto& a) -> auto& { return a.port; })
              .says("Port to listen on; 0: any free port"),
          R("host", "ADDR", any_text(), "127.0.0.1")
              .at([](auto& a) -> auto& { return a.host; })
              .says("Address to listen on", "address to listen on; `0.0.0.0`: all"),
          R("token", "T", any_text())
              .at([](auto& a) -> auto& { return a.token; })
              .says("Secret that viewers must give; needed if other machines can connect",
                    "secret that viewers must give; needed if other machines can connect, else exit code 2"),
          R("sessions", "N", whole(1, 48), "8")
              .at([](auto& a) -> auto& { return a.sessions; })
              .says("Maximum number of viewers at a time", "maximum number of viewers at a time, 1 to 48")}}};
    return all;
}

template <>
const std::vector<Group<EnvArguments>>& groups<EnvArguments>()
{
    using R = Row<EnvArguments>;
    static const std::vector<Group<EnvArguments>> all = {
        {"Options",
         command::env,
         {R("name", "NAME", any_text("kitchen studio sky furnace"))
              .at([](auto& a) -> auto& { return a.name; })
              .form(Form::positional)
              .says("kitchen, studio, sky or furnace"),
          R("output", "FILE", any_text())
              .at([](auto& a) -> auto& { return a.output; })
              .form(Form::required, 'o')
              .says("The panorama: .hdr or .exr"),
          R("size", "WxH", {Domain::Kind::size})
              .at({set_width, width_word})
              .usually("1024x512; kitchen 2048x1024")
              .says("Size in texels, twice as wide as high",
                    "size in texels: the width is a power of two from 64 to 8192, the height half of it"),
          R("sun", "AZ,EL", {Domain::Kind::orbit})
              .at({set_sun, sun_word})
              .usually("-46,40")
              .says("sky: azimuth and elevation of the sun in degrees, as for --camera",
                    "`sky`: azimuth and elevation of the sun in degrees, -5.7 to 90 above the horizon"),
          R("turbidity", "T", number(1.5, 10.0), "2.2")
              .at([](auto& a) -> auto& { return a.builtin.turbidity; })
              .says("sky: turbidity (haze), 1.5 to 10")}}};
    return all;
}

template <>
const std::vector<Group<InfoArguments>>& groups<InfoArguments>()
{
    using R = Row<InfoArguments>;
    static const std::vector<Group<InfoArguments>> all = {
        {"Options",
         command::info,
         {R("file", "FILE", any_text())
              .at([](auto& a) -> auto& { return a.file; })
              .form(Form::positional)
              .says("A .gltf, .glb, .hdr, .exr, .png or .jpg"),
          R("json").at([](auto& a) -> auto& { return a.json; }).says("Print one JSON object")}}};
    return all;
}

} // namespace lambent::cli
