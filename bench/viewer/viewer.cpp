// What a viewer of `grid` in the kitchen at 1280x720 gets from a server on the same machine: frames while it moves,
// the time from an input to the picture that shows it, decoded, and to the picture at rest; and the same while another
// viewer's picture of 1024 samples is drawn.
#include "apps/serve/server.h"
#include "image/codes/jpeg.h"
#include "image/codes/png.h"
#include "tests/serve/visitor.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <thread>

namespace {

using namespace lambent;
using Clock = std::chrono::steady_clock;
using serve::test::Visitor;

double ms_between(Clock::time_point from, Clock::time_point to)
{
    return std::chrono::duration<double, std::milli>(to - from).count();
}

double quantile(std::vector<double> values, double part)
{
    if (values.empty())
        return 0.0;
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1,
                           static_cast<std::size_t>(part * static_cast<double>(values.size())))];
}

void decode(const Visitor::Frame& frame)
{
    const std::span<const std::uint8_t> bytes(reinterpret_cast<const std::uint8_t*>(frame.picture.data()),
                                              frame.picture.size());
    if (frame.header.at("format") == "jpeg")
        image::decode_jpeg(bytes, "frame");
    else
        image::decode_png(bytes, "frame");
}

struct Moving {
    double rate = 0.0, scale = 0.0, kilobytes = 0.0;
    std::vector<double> latency;
};

nlohmann::json turn(std::uint64_t id)
{
    return {{"do", "orbit"}, {"x", 0.7}, {"y", 0.0}, {"id", id}};
}

// Turns for some seconds: an input for each frame that came, and one more under way.
Moving move(Visitor& visitor, std::uint64_t& id, double seconds)
{
    Moving moving;
    std::map<std::uint64_t, Clock::time_point> sent;
    const auto send = [&] {
        sent[++id] = Clock::now();
        visitor.send(turn(id));
    };
    send();
    const Clock::time_point start = Clock::now();
    int frames = 0;
    while (ms_between(start, Clock::now()) < 1000.0 * seconds) {
        send();
        const Visitor::Frame frame = visitor.next();
        decode(frame);
        const Clock::time_point now = Clock::now();
        // Each input is shown by the first frame that has it; the oldest of them waited longest.
        const std::uint64_t shown = frame.header.at("input");
        if (const auto oldest = sent.begin(); oldest != sent.end() && oldest->first <= shown)
            moving.latency.push_back(ms_between(oldest->second, now));
        sent.erase(sent.begin(), sent.upper_bound(shown));
        ++frames;
        moving.scale += frame.header.at("scale").get<double>();
        moving.kilobytes += static_cast<double>(frame.picture.size()) / 1024.0;
    }
    moving.rate = frames / (ms_between(start, Clock::now()) / 1000.0);
    moving.scale /= frames;
    moving.kilobytes /= frames;
    return moving;
}

struct Single {
    std::vector<double> first, rest;
};

// Single inputs from rest: until something shows them, and until the picture of all samples does.
Single from_rest(Visitor& visitor, std::uint64_t& id, int count)
{
    Single single;
    for (int i = 0; i < count; ++i) {
        visitor.wait_for("rest", id);
        const Clock::time_point start = Clock::now();
        visitor.send(turn(++id));
        decode(visitor.wait_for("moving", id));
        single.first.push_back(ms_between(start, Clock::now()));
        decode(visitor.wait_for("rest", id));
        single.rest.push_back(ms_between(start, Clock::now()));
        visitor.send({{"do", "orbit"}, {"x", 0.1}, {"y", 0.0}, {"id", ++id}});
    }
    return single;
}

// Another viewer comes to rest with so many samples that nothing else would be drawn for long.
void rest_long(Visitor& other)
{
    std::uint64_t id = 0;
    other.wait_for("rest", id);
    other.send({{"do", "set"}, {"name", "samples"}, {"value", "1024"}, {"id", ++id}});
    other.wait_for("still", id);
}

void print(const Moving& moving, const Moving& beside, const Single& single)
{
    std::printf("| grid, kitchen, 1280x720 | median | 95 of 100 |\n| --- | --- | --- |\n");
    std::printf("| frames a second while moving | %.1f | |\n", moving.rate);
    std::printf("| scale of their sides | %.2f | |\n", moving.scale);
    std::printf("| a frame, KiB | %.0f | |\n", moving.kilobytes);
    const auto row = [](const char* what, const std::vector<double>& values) {
        std::printf("| %s, ms | %.0f | %.0f |\n", what, quantile(values, 0.5), quantile(values, 0.95));
    };
    row("from input to picture while moving", moving.latency);
    std::printf("| frames a second beside a picture of 1024 samples | %.1f | |\n", beside.rate);
    std::printf("| scale of their sides | %.2f | |\n", beside.scale);
    row("from input to picture then", beside.latency);
    row("from input to picture, from rest", single.first);
    row("from input to the picture at rest", single.rest);
}

} // namespace

int main()
{
    viewer::ViewRequest start = viewer::default_request("grid", "kitchen");
    viewer::AssetCache assets;
    assets.load(viewer::arguments_of(start));
    viewer::DrawScheduler scheduler(assets);
    serve::ServerOptions options;
    options.port = 0;
    serve::Server server(options, start, viewer::FileList({}), assets, scheduler);
    std::thread thread([&] { server.run(); });
    std::uint64_t id = 0;
    {
        Visitor visitor(server.port());
        visitor.wait_for("rest", 0);
        move(visitor, id, 2.0); // finds its scale
        const Moving moving = move(visitor, id, 4.0);
        const Single single = from_rest(visitor, id, 5);
        Visitor other(server.port());
        rest_long(other);
        print(moving, move(visitor, id, 4.0), single);
    }
    server.stop();
    thread.join();
}
