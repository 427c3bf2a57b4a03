#include "bench/cycles/programs.h"

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "bench/whole/glb_writer.h"
#include "image/files/image_io.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <sstream>

#include <sys/resource.h>

namespace lambent::bench {
namespace {

using Json = nlohmann::json;

constexpr double patience = 3600.0; // seconds

// Of nearly black facets: above what Cycles takes for black (1e-5).
constexpr double dark = 1e-4;

testing::Outcome run(const std::string& program, const std::vector<std::string>& words)
{
    testing::Outcome outcome = testing::run_program(program, words, patience);
    if (outcome.code != 0)
        throw Error(Failure::bad_input, text(program, " failed (", outcome.code, "): ", outcome.error));
    return outcome;
}

// CPU seconds of all programs that have ended.
double children_cpu()
{
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

Json triple(const glm::vec3& v)
{
    return {v.x, v.y, v.z};
}

void add_mesh(const scene::Mesh& mesh, Json& job)
{
    for (const glm::vec3& position : mesh.positions)
        job["positions"].push_back(triple(position));
    for (const auto& triangle : mesh.triangles)
        job["triangles"].push_back({triangle[0], triangle[1], triangle[2]});
}

void add_spheres(const scene::Scene& grid, Json& job)
{
    for (const scene::Instance& instance : grid.instances)
        job["spheres"].push_back(
            {{"centre", triple(glm::vec3(instance.transform[3]))},
             {"roughness",
              grid.materials[static_cast<std::size_t>(instance.material)].perceptual_roughness}});
}

Json describe(const view::Camera& camera)
{
    return {{"position", triple(camera.position)},
            {"right", triple(camera.right)},
            {"up", triple(camera.up)},
            {"back", triple(camera.back)},
            {"vertical_fov", camera.vertical_fov}};
}

std::string name_of(PictureSize size)
{
    return text(size.width, "x", size.height);
}

void write_text(const std::string& path, const std::string& words)
{
    write_file(path, std::vector<std::uint8_t>(words.begin(), words.end()));
}

} // namespace

bool have_blender()
{
    const testing::Outcome version =
        testing::run_program("sh", {"-c", "command -v blender && blender --version"});
    return version.code == 0 && version.output.find("Blender 3.4") != std::string::npos;
}

Programs::Programs(const Job& job) : job_(job), grid_(make_white_grid())
{
    write_glb(grid_, folder_.path("grid.glb"));
    // One file for both: what a built-in environment is, Blender learns from its texels.
    const bool file = std::filesystem::path(job.environment).has_extension();
    if (!file)
        run(LAMBENT_PROGRAM, {"env", job.environment, "-o", folder_.path("panorama.exr")});
    job_.environment =
        file ? std::filesystem::absolute(job.environment).string() : folder_.path("panorama.exr");
}

std::string Programs::output(std::size_t number) const
{
    return folder_.path(text("picture", number, ".exr"));
}

std::string Programs::job_text(const std::vector<Order>& orders) const
{
    Json job = {{"panorama", job_.environment},
                {"width", job_.size.width},
                {"height", job_.size.height},
                {"bounces", job_.bounces},
                {"threads", job_.threads},
                {"adaptive", job_.adaptive},
                {"distribution", job_.lobe == Lobe::separable ? "GGX" : "MULTI_GGX"},
                {"reflectance", job_.lobe == Lobe::single ? dark : 1.0},
                {"camera", describe(grid_camera(grid_, job_.size))}};
    add_mesh(grid_.meshes[0], job);
    add_spheres(grid_, job);
    for (std::size_t i = 0; i < orders.size(); ++i)
        job["pictures"].push_back(
            {{"samples", orders[i].samples}, {"seed", orders[i].seed}, {"output", output(i)}});
    return job.dump();
}

Series Programs::cycles(const std::vector<Order>& orders) const
{
    const std::string job = folder_.path("job.json");
    write_text(job, job_text(orders));
    const testing::Outcome outcome =
        run("blender", {"-b", "--factory-startup", "--python-exit-code", "1", "-t", text(job_.threads),
                        "--python", LAMBENT_CYCLES_SCRIPT, "--", job});
    Series series;
    series.start_seconds = outcome.seconds;
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);) {
        Taken taken;
        if (std::sscanf(line.c_str(), "picture %lf %lf", &taken.seconds, &taken.cpu_seconds) != 2)
            continue;
        taken.radiance = image::read_radiance(output(series.pictures.size()));
        if (job_.lobe == Lobe::single)
            for (float& value : taken.radiance.values)
                value *= static_cast<float>(1.0 / dark);
        series.start_seconds -= taken.seconds;
        series.pictures.push_back(std::move(taken));
    }
    if (series.pictures.size() != orders.size())
        throw Error(Failure::bad_input, text("blender made ", series.pictures.size(), " of ", orders.size(),
                                             " pictures: ", outcome.error));
    return series;
}

Taken Programs::one_of_lambent(const Order& order, double& start_seconds) const
{
    std::vector<std::string> words = {"reference", folder_.path("grid.glb"),
                                      "--env",     job_.environment,
                                      "--camera",  "0,0",
                                      "--size",    name_of(job_.size),
                                      "--spp",     text(order.samples),
                                      "--seed",    text(order.seed),
                                      "--bounces", text(job_.bounces),
                                      "--threads", text(job_.threads),
                                      "--uniform", "--quiet",
                                      "--stats",   "json",
                                      "-o",        output(0)};
    if (job_.lobe != Lobe::multiple)
        words.emplace_back("--no-energy-compensation");
    const double before = children_cpu();
    const testing::Outcome outcome = run(LAMBENT_PROGRAM, words);
    Taken taken;
    taken.cpu_seconds = children_cpu() - before;
    taken.seconds = Json::parse(outcome.output).at("times_ms").at("trace").get<double>() / 1e3;
    taken.radiance = image::read_radiance(output(0));
    start_seconds = outcome.seconds - taken.seconds;
    return taken;
}

Series Programs::lambent(const std::vector<Order>& orders) const
{
    Series series;
    for (const Order& order : orders)
        series.pictures.push_back(one_of_lambent(order, series.start_seconds));
    return series;
}

} // namespace lambent::bench
