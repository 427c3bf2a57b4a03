// The tables of docs/ERRORS.md: how far drawn pictures are off path-traced ones.
//
//     error_tables OUT.md [--width N] [--seconds S] [--scene NAME] [FILE ...]
//
// FILEs are panoramas (.hdr, .exr) and models (.gltf, .glb) beside the built-in ones; --scene: that built-in scene alone, and no model.
#include "bench/errors/error_cases.h"

#include "base/error.h"
#include "base/text.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

namespace {

using namespace lambent;
using bench::CaseErrors, bench::RegionError;

struct Request {
    std::string output;
    int width = 640;
    double seconds = 6.0;
    std::vector<std::string> scenes = {"report", "teapot"};
    std::vector<std::string> environments = {"kitchen", "sky", "studio"};
};

Request request_of(int count, char** words)
{
    Request request;
    std::vector<std::string> models;
    std::string one_scene;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        const std::string extension = std::filesystem::path(word).extension().string();
        if (word == "--width" && i + 1 < count)
            request.width = std::atoi(words[++i]);
        else if (word == "--seconds" && i + 1 < count)
            request.seconds = std::atof(words[++i]);
        else if (word == "--scene" && i + 1 < count)
            one_scene = words[++i];
        else if (extension == ".glb" || extension == ".gltf")
            models.push_back(word);
        else if (extension == ".hdr" || extension == ".exr")
            request.environments.push_back(word);
        else
            request.output = word;
    }
    if (one_scene.empty())
        request.scenes.insert(request.scenes.end(), models.begin(), models.end());
    else
        request.scenes = {one_scene};
    return request;
}

// Files keep their endings, which tell them from the built-in ones.
std::string short_name(const std::string& name)
{
    return std::filesystem::path(name).filename().string();
}

std::string percent(double share)
{
    char word[32];
    std::snprintf(word, sizeof word, share < 0.0995 ? "%.1f %%" : "%.0f %%", 100.0 * share);
    return word;
}

// An error that the noise of the references hides is given by its bound.
std::string percent(const RegionError& error)
{
    return error.resolved ? percent(error.mean) : "< " + percent(error.most);
}

void write_row(std::ofstream& out, const std::string& environment, const CaseErrors& e)
{
    out << "| " << environment;
    for (const RegionError* error : {&e.clamped_40, &e.clamped_1024, &e.whole_40, &e.whole_1024, &e.full_40})
        out << " | " << percent(*error);
    out << " |\n" << std::flush;
}

void write_tables(const Request& request)
{
    std::ofstream out(request.output);
    for (const std::string& scene : request.scenes)
        for (const char* model : {"ggx", "phong"}) {
            out << "\n### " << short_name(scene) << ", " << model << ", " << request.width << "x"
                << request.width * 9 / 16 << "\n\n"
                << "| environment | 40 samples | 1024 samples | 40, not cut | 1024, not cut | 40, against "
                   "full light "
                   "|\n| --- | --- | --- | --- | --- | --- |\n";
            for (const std::string& environment : request.environments) {
                const CaseErrors errors =
                    bench::measure({scene, environment, model}, request.width, request.seconds);
                write_row(out, short_name(environment), errors);
                std::printf("%s %s %s: 40: %s, 1024: %s, full: %s\n", short_name(scene).c_str(), model,
                            short_name(environment).c_str(), percent(errors.clamped_40).c_str(),
                            percent(errors.clamped_1024).c_str(), percent(errors.full_40).c_str());
                std::fflush(stdout);
            }
        }
}

} // namespace

int main(int count, char** words)
{
    const Request request = request_of(count, words);
    if (request.output.empty() || request.width < 16) {
        std::fputs("usage: error_tables OUT.md [--width N] [--seconds S] [--scene NAME] [FILE ...]\n",
                   stderr);
        return 2;
    }
    try {
        write_tables(request);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error_tables: %s\n", error.what());
        return 1;
    }
    return 0;
}
