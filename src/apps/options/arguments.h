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

/// How much is said beside the result.
enum class Verbosity { quiet, normal, verbose };

struct CommonOptions {
    Verbosity verbosity = Verbosity::normal;
    int threads = 0; ///< 0: one per processor
    bool stats_json = false;
    bool strict = false; ///< what an input is warned of is an error
};

/// Who draws or bakes. Automatic: a graphics device where there is one, else the processor.
enum class Backend { automatic, cpu, vulkan };

struct RenderArguments {
    CommonOptions common;
    Backend backend = Backend::automatic;
    std::string scene;
    std::string environment = "kitchen";
    bool cache = true; ///< of environments
    std::string output;
    std::string layers; ///< folder; empty: none
    draw::Settings settings;
    bool split_sum = false; ///< specular light by draw::split_sum_samples, whatever the settings' samples
    bool report_pipeline = false;     ///< as draw::ReportPipeline
    int bounces = 8;                  ///< of light, where it is traced
    std::string shown = "picture";    ///< by viewers: the picture, the reference, the error or a layer
    std::optional<view::Orbit> orbit; ///< unset: the default view, or camera_node
    std::optional<glm::dvec3> target; ///< in the world, what the orbit is around; unset: the scene's middle
    std::vector<glm::dvec3> light_places; ///< in the world, of each light of the settings
    std::vector<std::string> light_words; ///< of --light, of each of them
    std::string camera_node;
    std::string animation;        ///< name or number; empty: none, or the first, if there is a moment
    std::optional<double> moment; ///< seconds; unset: the animation's start, if there is one
    float vertical_fov = 0.7853982f;
    display::Settings display;
    scene::BuiltinOptions builtin;
};

/// The picture of RenderArguments, path-traced. What says how to approximate changes nothing here.
struct ReferenceArguments {
    RenderArguments picture;
    std::optional<int> samples;    ///< per pixel; unset: no limit
    std::optional<double> noise;   ///< estimated relative RMSE
    std::optional<double> seconds; ///< none of the three: noise 0.01 or 1024 samples
    bool uniform = false;          ///< as many samples for every pixel
    std::uint32_t seed = 0;
    std::string variance; ///< file; empty: none
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
    std::optional<float> clamp;    ///< cut to [0, this], after the exposure
    double pixels_per_degree = 67.0;
    bool json = false;              ///< even on a terminal
    std::optional<double> max_flip; ///< bounds that make it exit 1
    std::optional<double> max_relative;
};

/// What a bake writes: a cube map for renderers, or pictures.
enum class BakeFormat { ktx2, dds, exr, hdr };

/// Pictures of a cube: its faces apart, unfolded, or unrolled.
enum class CubeLayout { faces, cross, equirectangular };

struct BakeArguments {
    CommonOptions common;
    std::string environment;
    std::string output;
    bool one_file = false; ///< a .ktx2 or .dds with the specular light, else a folder for everything
    environment::BakeOptions options;
    std::optional<int> samples;         ///< instead of the options' error: that of so many
    std::optional<int> irradiance_size; ///< 0: coefficients alone; unset: usual_irradiance_size
    std::optional<int> table_size;      ///< unset: usual_table_size
    double rotation = 0.0;              ///< of the environment, degrees
    BakeFormat format = BakeFormat::ktx2;
    CubeLayout layout = CubeLayout::faces;
    image::TexelFormat texels = image::TexelFormat::half4;
    bool zstd = false, mirrored = false;
    Backend backend = Backend::automatic;
    bool cache = true; ///< of a device's compiled shaders

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
    double noise = 0.02;                  ///< of references,
    int samples = 48;                     ///< or this
    bool cache = true;                    ///< of environments
    Backend backend = Backend::automatic; ///< not a device: figures are the processor's
};

/// What a viewer shows at first.
struct StartArguments {
    RenderArguments picture; ///< as `render` understands the words; without an output
    Given given;             ///< the words
};

struct ViewArguments {
    StartArguments start;
    std::vector<std::string> words; ///< the whole command line
};

struct ServeArguments {
    StartArguments start;
    std::string host = "127.0.0.1"; ///< an address, or localhost
    std::uint16_t port = 8080;      ///< 0: any that is free
    std::string token;              ///< empty: none
    int sessions = 8;               ///< at once
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

/// What any command line asks for.
using Arguments =
    std::variant<PrintText, RenderArguments, BakeArguments, ReferenceArguments, CompareArguments,
                 ReportArguments, ViewArguments, ServeArguments, EnvArguments, InfoArguments>;

/// Throws Error(usage) with one line for whatever is wrong.
Arguments parse_arguments(int count, const char* const* words);

} // namespace lambent::cli
