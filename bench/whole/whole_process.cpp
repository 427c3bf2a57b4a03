// From the command to the picture on disk: 7x7 spheres under a panorama, 1280x720, 40 samples; and the same with F3D
// where it is installed, in turn.
#include "bench/side_by_side.h"
#include "bench/whole/glb_writer.h"
#include "scene/builtin/builtin.h"
#include "tests/support/process.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace lambent;
using testing::Outcome;

struct Runs {
    std::vector<double> seconds;
    double megabytes = 0.0;

    void add(const Outcome& outcome)
    {
        if (outcome.code != 0) {
            std::fprintf(stderr, "failed (%d): %s\n", outcome.code, outcome.error.c_str());
            std::exit(1);
        }
        seconds.push_back(outcome.seconds);
        megabytes = std::max(megabytes, outcome.megabytes);
    }

    void print(const char* name) const
    {
        std::printf("  %-10s %8.3f s (%.3f to %.3f), %4.0f MB\n", name, bench::median(seconds),
                    *std::min_element(seconds.begin(), seconds.end()),
                    *std::max_element(seconds.begin(), seconds.end()), megabytes);
    }
};

bool have_f3d()
{
    return std::system("command -v f3d xvfb-run >/dev/null 2>&1") == 0;
}

void compare(const testing::Folder& folder, const std::string& size, int rounds)
{
    const std::string panorama = folder.path(size + ".hdr"), out = folder.path("out.png");
    testing::run_program(LAMBENT_PROGRAM, {"env", "studio", "-o", panorama, "--size", size});
    const bool rival = have_f3d();
    Runs ours, light, f3d;
    for (int round = 0; round < rounds; ++round) {
        ours.add(testing::run_program(LAMBENT_PROGRAM, {"render", "grid", "--bounces", "0", "--env", panorama,
                                                        "-o", out, "--threads", "2"}));
        if (round < 3)
            light.add(testing::run_program(LAMBENT_PROGRAM, {"render", "grid", "--no-audit", "--env",
                                                             panorama, "-o", out, "--threads", "2"}));
        if (rival && round < 3)
            f3d.add(testing::run_program("xvfb-run",
                                         {"-a", "f3d", "--dry-run", "--quiet", "--resolution=1280,720",
                                          "--hdri=" + panorama, "--output=" + out, folder.path("grid.glb")},
                                         300.0));
    }
    std::printf("%s panorama\n", size.c_str());
    ours.print("lambent");
    light.print("all light");
    std::printf("  times      %8.2f\n", bench::median(light.seconds) / bench::median(ours.seconds));
    if (rival) {
        f3d.print("F3D");
        std::printf("  ratio      %8.3f\n", bench::median(ours.seconds) / bench::median(f3d.seconds));
    }
    std::fflush(stdout);
}

} // namespace

int main()
{
    const testing::Folder folder;
    bench::write_glb(scene::make_builtin("grid"), folder.path("grid.glb"));
    std::printf("whole process, grid, 1280x720, 40 samples, 2 threads%s\n",
                have_f3d() ? "" : " (F3D and xvfb-run are not installed: no rival)");
    compare(folder, "1024x512", 9);
    compare(folder, "4096x2048", 5);
}
