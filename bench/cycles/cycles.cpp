// `lambent reference` beside Blender's Cycles: the same light within noise? And how long to the same error?
//
//     bench_cycles [--env NAME|FILE] [--size WxH] [--spp N] [--seeds N] [--bounces N] [--rounds N]
//                  [--single|--separable] [--adaptive]
//
// --single, --separable: see Lobe. --rounds 0: no timing. --adaptive: Cycles' adaptive sampling.
#include "bench/cycles/agreement.h"
#include "bench/cycles/equal_error.h"
#include "bench/cycles/programs.h"

#include <algorithm>
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

bool set_flag(Request& request, const std::string& word)
{
    if (word == "--separable") {
        request.job.lobe = bench::Lobe::separable;
    } else if (word == "--single") {
        request.job.lobe = bench::Lobe::single;
        request.job.bounces = 1;
        request.rounds = 0;
    } else if (word == "--adaptive")
        request.job.adaptive = true;
    else
        return false;
    return true;
}

bool set_value(Request& request, const std::string& word, const char* value)
{
    bench::PictureSize& size = request.job.size;
    if (word == "--size")
        return std::sscanf(value, "%dx%d", &size.width, &size.height) == 2;
    if (word == "--env") {
        request.job.environment = value;
        return true;
    }
    int* number = word == "--spp"       ? &request.samples
                  : word == "--seeds"   ? &request.seeds
                  : word == "--bounces" ? &request.job.bounces
                  : word == "--rounds"  ? &request.rounds
                                        : nullptr;
    if (number)
        *number = std::atoi(value);
    return number != nullptr;
}

Request request_of(int count, char** words)
{
    Request request;
    for (int i = 1; i < count; ++i)
        if (!set_flag(request, words[i])) {
            request.understood &= i + 1 < count && set_value(request, words[i], words[i + 1]);
            ++i;
        }
    const bench::PictureSize size = request.job.size;
    request.understood &= request.samples > 0 && request.seeds >= 4 && request.job.bounces >= 1 &&
                          (request.job.lobe != bench::Lobe::single || request.job.bounces == 1) &&
                          std::min(size.width, size.height) >= 64 &&
                          std::max(size.width, size.height) <= 8192;
    return request;
}

const char* name_of(bench::Lobe lobe)
{
    return lobe == bench::Lobe::multiple ? "multiscatter"
           : lobe == bench::Lobe::single ? "single"
                                         : "separable";
}

void compare(const Request& request)
{
    const bench::Job& job = request.job;
    const bench::Programs programs(job);
    std::vector<bench::Order> orders;
    for (int seed = 1; seed <= request.seeds; ++seed)
        orders.push_back({request.samples, static_cast<std::uint32_t>(seed)});
    std::printf("%s, %dx%d, %d bounces, %s GGX, %d seeds of %d samples per pixel\n", job.environment.c_str(),
                job.size.width, job.size.height, job.bounces, name_of(job.lobe), request.seeds,
                request.samples);
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
                   "[--rounds N] [--single|--separable] [--adaptive]\n",
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
