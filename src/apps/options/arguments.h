// The command line as a value.
#pragma once

#include "apps/options/given.h"
#include "display/display.h"
#include "draw/settings.h"
#include "environment/bake/bake.h"
#include "environment/builtin/builtin.h"
#include "image/cube/cube_files.h"
#include "scene/builtin/builtin.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace lambent::cli {

/// How much is printed besides the result.
enum class Verbosity { quiet, normal, verbose };

struct CommonOptions {
    Verbosity verbosity = Verbosity::normal;
    int threads = 0; ///< 0: one per processor
    bool stats_json = false;
    bool strict = false; ///< warnings about input files are errors
};

/// What draws or bakes. Automatic: a hardware Vulkan device if there is one, else the CPU.
enum class Backend { automatic, cpu, vulkan };

struct RenderArguments {
    CommonOptions common;
    Backend backend = Backend::automatic;
    std::string scene;
    std::string environment = "kitchen";
    bool cache = true; ///< use the environment cache
    std::string output;
    std::string layers; ///< folder; empty: none
    draw::Settings settings;
    bool split_sum = false;       ///< specular light by draw::split_sum_samples, not the settings' samples
    bool report_pipeline = false; ///< draw as draw::ReportPipeline
    int bounces = 8;           ///< of light, as asked for; of the drawing: settings.bounces, set by derive()
    bool audit = true;         ///< measure the picture's error if it is drawn with bounces
    bool audit_always = false; ///< measure it without bounces too
    std::optional<double> error;      ///< drawing: refine until the measured error is at most this
    std::optional<double> seconds;    ///< drawing: refine for so long
    std::string shown = "picture";    ///< in viewers: the picture, the reference, the error or a layer
    std::optional<view::Orbit> orbit; ///< unset: the default view, or camera_node
    std::optional<glm::dvec3>
        target; ///< point in the world that the orbit is around; unset: the scene's centre
    std::vector<glm::dvec3> light_places; ///< position in the world of each of the settings' lights
    std::vector<std::string> light_words; ///< the word of --light for each of them
    std::string camera_node;
    std::string animation;        ///< name or number; empty: none, or the first if `moment` is set
    std::optional<double> moment; ///< seconds from the animation's start; unset: its start
    float vertical_fov = 0.7853982f;
    display::Settings display;
    scene::BuiltinOptions builtin;
};

/// Whether the error of the picture is measured.
bool is_audited(const RenderArguments& arguments);

/// The picture of RenderArguments, path-traced. Options that choose an approximation have no effect.
struct ReferenceArguments {
    RenderArguments picture;
    std::optional<int> samples;    ///< per pixel; unset: no limit
    std::optional<double> noise;   ///< limit of the estimated relative RMSE
    std::optional<double> seconds; ///< limit of the time; without any limit: noise 0.01 or 1024 samples
    bool uniform = false;          ///< the same number of samples for every pixel
    std::uint32_t seed = 0;
    std::string variance; ///< file; empty: none
    bool denoise = false; ///< filter the picture
    bool audit = true;    ///< measure the filtered picture's error
};

/// Which error the heat map shows.
enum class Heat { flip, relative, absolute };

struct CompareArguments {
    CommonOptions common;
    std::string picture;
    std::string reference;
    std::string output; ///< the heat map; empty: none
    Heat heat = Heat::flip;
    std::optional<float> exposure; ///< linear light only
    std::optional<float> clamp;    ///< upper bound of values, after the exposure
    bool covered = false;          ///< only the pixels that surfaces cover
    double pixels_per_degree = 67.0;
    bool json = false;                  ///< print JSON even on a terminal
    std::optional<double> max_flip;     ///< exit code 1 above this
    std::optional<double> max_relative; ///< the same of the relative RMSE
};

/// File formats of a bake: cube maps for renderers, or pictures.
enum class BakeFormat { ktx2, dds, exr, hdr };

/// How pictures show a cube: one for each face, a cross, or a panorama.
enum class CubeLayout { faces, cross, equirectangular };

struct BakeArguments {
    CommonOptions common;
    std::string environment;
    std::string output;
    bool one_file = false; ///< a .ktx2 or .dds with the specular light, else a folder for all files
    environment::BakeOptions options;
    std::optional<int> samples;         ///< sets the options' error to that of this many samples
    std::optional<int> irradiance_size; ///< 0: coefficients only; unset: usual_irradiance_size
    std::optional<int> table_size;      ///< unset: usual_table_size
    double rotation = 0.0;              ///< of the environment, degrees
    BakeFormat format = BakeFormat::ktx2;
    CubeLayout layout = CubeLayout::faces;
    image::TexelFormat texels = image::TexelFormat::half4;
    bool zstd = false, mirrored = false;
    Backend backend = Backend::automatic;
    bool cache = true; ///< keep a device's compiled shaders

    static constexpr int usual_irradiance_size = 32, usual_table_size = 128;
    static constexpr double least_error = 0.0005, most_error = 0.2;
};

struct ReportArguments {
    CommonOptions common;
    std::string environment = "kitchen";
    std::string output;                   ///< folder
    int width = 512, height = 288;        ///< of a figure
    double rotation = 0.0;                ///< of the environment, degrees
    bool quick = false;                   ///< without references
    double noise = 0.02;                  ///< limit of references: estimated relative RMSE
    int samples = 48;                     ///< limit of references: samples per pixel
    bool cache = true;                    ///< use the environment cache
    Backend backend = Backend::automatic; ///< never vulkan: figures are drawn on the CPU
};

/// What a viewer shows at first.
struct StartArguments {
    RenderArguments picture; ///< the options as `render` takes them; no output
    Given given;             ///< the options as given
};

struct ViewArguments {
    StartArguments start;
    std::vector<std::string> words; ///< the whole command line
};

struct ServeArguments {
    StartArguments start;
    std::string host = "127.0.0.1"; ///< an address, or localhost
    std::uint16_t port = 8080;      ///< 0: any free port
    std::string token;              ///< empty: none
    int sessions = 8;               ///< maximum number of viewers at a time
};

struct EnvArguments {
    CommonOptions common;
    std::string name;
    std::string output;
    environment::BuiltinOptions builtin;
};

struct InfoArguments {
    CommonOptions common;
    std::string file;
    bool json = false;
};

/// Text to be printed instead of doing anything: --help, --version.
struct PrintText {
    std::string text;
};

/// The arguments of one of the commands, or text to print.
using Arguments =
    std::variant<PrintText, RenderArguments, BakeArguments, ReferenceArguments, CompareArguments,
                 ReportArguments, ViewArguments, ServeArguments, EnvArguments, InfoArguments>;

/// Throws Error(usage) with one line that says what is wrong.
Arguments parse_arguments(int count, const char* const* words);

} // namespace lambent::cli
