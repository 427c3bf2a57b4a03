// `lambent reference` beside Blender's Cycles: the same light within noise? And how long to the same error?
//
//     bench_cycles [--env NAME|FILE] [--size WxH] [--spp N] [--seeds N] [--bounces N] [--rounds N] [--plain] [--adaptive]
//
// --plain: GGX without light scattered more than once. --rounds 0: no timing. --adaptive: Cycles' adaptive sampling.
#include "bench/cycles/agreement.h"
#include "bench/cycles/equal_error.h"
#include "bench/cycles/programs.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

namespace {

using namespace lambent;

struct Request {
    bench::Job job{.environment = "studio"};
    int samples = 256;
    int seeds = 8;
    int rounds = 3;
    bool understood = true;
};

// Whether `word` with `value` is an option of a number.
bool set_number(Request& request, const std::string& word, int value)
{
    int* number = word == "--spp"       ? &request.samples
                  : word == "--seeds"   ? &request.seeds
                  : word == "--bounces" ? &request.job.bounces
                  : word == "--rounds"  ? &request.rounds
                                        : nullptr;
    if (number)
        *number = value;
    return number != nullptr;
}

Request request_of(int count, char** words)
{
    Request request;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        const char* value = i + 1 < count ? words[i + 1] : "";
        bench::PictureSize& size = request.job.size;
        if (word == "--plain")
            request.job.multiple_scattering = false;
        else if (word == "--adaptive")
            request.job.adaptive = true;
        else if (word == "--env")
            request.job.environment = words[++i < count ? i : 0];
        else if (word == "--size")
            request.understood &=
                std::sscanf(words[++i < count ? i : 0], "%dx%d", &size.width, &size.height) == 2;
        else if (set_number(request, word, std::atoi(value)))
            ++i;
        else
            request.understood = false;
    }
    const bench::PictureSize size = request.job.size;
    request.understood &= request.samples > 0 && request.seeds >= 4 && request.job.bounces >= 1 &&
                          size.width >= 64 && size.height >= 64 && size.width <= 8192 && size.height <= 8192;
    return request;
}

void compare(const Request& request)
{
    const bench::Job& job = request.job;
    const bench::Programs programs(job);
    std::vector<bench::Order> orders;
    for (int seed = 1; seed <= request.seeds; ++seed)
        orders.push_back({request.samples, static_cast<std::uint32_t>(seed)});
    std::printf("%s, %dx%d, %d bounces, %s GGX, %d seeds of %d samples per pixel\n", job.environment.c_str(),
                job.size.width, job.size.height, job.bounces,
                job.multiple_scattering ? "multiscatter" : "plain", request.seeds, request.samples);
    std::fflush(stdout);
    bench::SamePictures same;
    same.lambent = programs.lambent(orders).pictures;
    same.cycles = programs.cycles(orders).pictures;
    bench::print_agreement(same, bench::inner_pixels(programs.grid(), job.size));
    if (request.rounds > 0)
        bench::print_time_to_equal_error(programs, same, request.rounds);
}

} // namespace

int main(int count, char** words)
{
    const Request request = request_of(count, words);
    if (!request.understood) {
        std::fputs("usage: bench_cycles [--env NAME|FILE] [--size WxH] [--spp N] [--seeds N] [--bounces N] "
                   "[--rounds N] [--plain] [--adaptive]\n",
                   stderr);
        return 2;
    }
    try {
        if (bench::have_blender())
            compare(request);
        else
            std::puts("Blender 3.4 is not installed: nothing to compare with");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_cycles: %s\n", error.what());
        return 1;
    }
    return 0;
}
