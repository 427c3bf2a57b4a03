// The server against those it is for and those it is not for.
#include "apps/serve/server.h"
#include "base/error.h"
#include "image/codes/jpeg.h"
#include "image/codes/png.h"
#include "tests/serve/visitor.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <fstream>

#include <sys/resource.h>

namespace lambent::serve {
namespace {

using test::get;
using test::Visitor;

viewer::ViewRequest small_wish()
{
    viewer::ViewRequest request = viewer::default_request("sphere", "furnace");
    viewer::set_size(request, 64, 48);
    viewer::set_value(request.asked, "samples", "8");
    return request;
}

// A server at a free port, which runs until its end.
struct Running {
    explicit Running(const ServerOptions& options = quick())
        : server(options, small_wish(), viewer::FileList({}), assets, scheduler),
          thread([this] { server.run(); })
    {
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running()
    {
        server.stop();
        thread.join();
    }

    static ServerOptions quick()
    {
        ServerOptions options;
        options.port = 0;
        options.limits.sessions = 4;
        options.limits.request_seconds = 2 * testing::patience;
        return options;
    }

    viewer::AssetCache assets{{.cache = false}};
    viewer::DrawScheduler scheduler{assets};
    Server server;
    std::thread thread;
};

bool starts_with_status(const std::string& answer, int status)
{
    return answer.starts_with("HTTP/1.1 " + std::to_string(status) + " ");
}

std::span<const std::uint8_t> bytes_of(const std::string& text)
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void expect_served(std::uint16_t port)
{
    Visitor visitor(port);
    visitor.send({{"do", "orbit"}, {"x", 10}, {"y", 0}, {"id", 1}});
    EXPECT_FALSE(visitor.wait_for("rest", 1).picture.empty());
}

TEST(Server, ServesThePageAndNothingElse)
{
    const Running running;
    const std::uint16_t port = running.server.port();
    const std::string page = get(port, "/");
    EXPECT_TRUE(starts_with_status(page, 200));
    EXPECT_NE(page.find("<title>lambent</title>"), std::string::npos);
    EXPECT_NE(page.find("Content-Security-Policy: default-src 'none'"), std::string::npos);
    for (const char* target : {"/index.html", "/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd",
                               "//etc/passwd", "/socket/..", "/?/../x/../..", "/page.js"})
        EXPECT_TRUE(starts_with_status(get(port, target), std::string(target).starts_with("/?") ? 200 : 404))
            << target;
    EXPECT_TRUE(starts_with_status(get(port, "/socket"), 426));
}

TEST(Server, RefusesWithAReason)
{
    const Running running;
    const std::uint16_t port = running.server.port();
    const std::string host = "Host: localhost\r\n";
    const auto line = [&](const std::string& request) { return test::ask(port, request); };
    EXPECT_TRUE(starts_with_status(line("GET / HTTP/1.1\r\n\r\n"), 400));
    EXPECT_TRUE(starts_with_status(line("GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n"), 403));
    EXPECT_TRUE(starts_with_status(get(port, "/", "Origin: http://evil.example\r\n"), 403));
    EXPECT_TRUE(starts_with_status(line("POST / HTTP/1.1\r\n" + host + "\r\n"), 405));
    EXPECT_TRUE(
        starts_with_status(line("POST / HTTP/1.1\r\n" + host + "Content-Length: 99999999999\r\n\r\nx"), 413));
    EXPECT_TRUE(starts_with_status(get(port, "/", "X: " + std::string(20000, 'x') + "\r\n"), 431));
    EXPECT_TRUE(starts_with_status(line("nonsense\r\n\r\n"), 400));
    EXPECT_NE(get(port, "/nowhere").find("nothing is served at this path"), std::string::npos);
    const std::string upgrade = "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                                "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
    const std::string elsewhere = get(port, "/socket", upgrade + "Origin: http://evil.example\r\n");
    EXPECT_TRUE(starts_with_status(elsewhere, 403));
    EXPECT_NE(elsewhere.find("Origin"), std::string::npos);
    expect_served(port);
}

TEST(Server, ATokenIsNeededWhereThereIsOne)
{
    ServerOptions options = Running::quick();
    options.token = "open sesame";
    const Running running(options);
    const std::uint16_t port = running.server.port();
    EXPECT_TRUE(starts_with_status(get(port, "/"), 401));
    EXPECT_TRUE(starts_with_status(get(port, "/?token=open"), 401));
    EXPECT_TRUE(starts_with_status(get(port, "/?token=open%20sesame"), 200));
    EXPECT_TRUE(starts_with_status(get(port, "/", "Authorization: Bearer open sesame\r\n"), 200));
    EXPECT_THROW(Visitor(port, "/socket"), boost::system::system_error);
    EXPECT_EQ(Visitor(port, "/socket?token=open%20sesame").wait_for_text("hello").at("type"), "hello");
    EXPECT_TRUE(running.server.url().ends_with("/?token=open%20sesame"));
}

TEST(Server, FramesArePicturesOfTheSizeTheySay)
{
    const Running running;
    Visitor visitor(running.server.port());
    const Visitor::Frame moving = visitor.wait_for("moving", 0), rest = visitor.wait_for("rest", 0);
    const image::CodeImage small = image::decode_jpeg(bytes_of(moving.picture), "moving");
    const image::CodeImage whole = image::decode_png(bytes_of(rest.picture), "rest");
    EXPECT_LT(small.width, 64);
    EXPECT_EQ(moving.header.at("width"), 64);
    EXPECT_EQ(whole.width, 64);
    EXPECT_EQ(whole.height, 48);
    EXPECT_EQ(rest.header.at("scale"), 1.0);
}

TEST(Server, WhatIsMalformedEndsItWithAReason)
{
    const Running running;
    const std::uint16_t port = running.server.port();
    for (const char* message : {"x", "[]", "{\"do\": \"fly\"}", "{\"do\": \"orbit\"}"}) {
        Visitor visitor(port);
        visitor.send_text(message);
        EXPECT_FALSE(visitor.reason().starts_with("no reason")) << message;
    }
    Visitor binary(port);
    binary.send_bytes("{}");
    EXPECT_EQ(binary.reason(), "messages must be text");
    Visitor large(port);
    // The server may hang up while it is sent.
    EXPECT_NO_THROW(large.send_text("{\"do\": \"" + std::string(9000, 'x') + "\"}"));
    large.reason();
    expect_served(port);
}

TEST(Server, WhatIsRefusedIsSaidAndItGoesOn)
{
    const Running running;
    Visitor visitor(running.server.port());
    visitor.send({{"do", "scene"}, {"name", "../../../etc/passwd.glb"}});
    EXPECT_NE(visitor.wait_for_text("error").at("line").get<std::string>().find("may be opened"),
              std::string::npos);
    visitor.send({{"do", "set"}, {"name", "exposure"}, {"value", -1}});
    visitor.wait_for_text("error");
    visitor.send({{"do", "orbit"}, {"x", 10}, {"y", 0}, {"id", 7}});
    visitor.wait_for("rest", 7);
}

TEST(Server, AFloodOfMessagesEndsIt)
{
    const Running running;
    Visitor visitor(running.server.port());
    try {
        for (int i = 0; i < 20000; ++i)
            visitor.send_text("{\"do\": \"seen\"}");
    } catch (const boost::system::system_error&) {
        // The server hung up meanwhile.
    }
    visitor.reason();
    expect_served(running.server.port());
}

TEST(Server, HasOnlySoManyPlaces)
{
    const Running running;
    const std::uint16_t port = running.server.port();
    {
        std::vector<std::unique_ptr<Visitor>> visitors;
        visitors.reserve(4);
        for (int i = 0; i < 4; ++i)
            visitors.push_back(std::make_unique<Visitor>(port));
        EXPECT_THROW(Visitor(port, "/socket"), boost::system::system_error);
        visitors[0]->send({{"do", "orbit"}, {"x", 10}, {"y", 0}, {"id", 1}});
        visitors[0]->wait_for("rest", 1);
    }
    for (int i = 0; i < 200 * testing::patience && running.server.sessions() > 0; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(running.server.sessions(), 0);
    expect_served(port);
}

TEST(Server, WhoDoesNotReadHoldsNobodyUp)
{
    const Running running;
    Visitor stalled(running.server.port()), other(running.server.port());
    for (std::uint64_t id = 1; id <= 30; ++id) {
        const nlohmann::json turn = {{"do", "orbit"}, {"x", 3}, {"y", 0}, {"id", id}};
        stalled.send(turn); // and reads nothing
        other.send(turn);
        other.wait_for("moving", id);
    }
    other.wait_for("rest", 30);
}

long peak_kilobytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

TEST(Server, AThousandConnectionsAreRefusedAndNobodyElseNotices)
{
    rlimit files{};
    getrlimit(RLIMIT_NOFILE, &files);
    if (files.rlim_max < 4096)
        GTEST_SKIP() << "not enough file descriptors";
    files.rlim_cur = 4096;
    setrlimit(RLIMIT_NOFILE, &files);
    const Running running;
    const std::uint16_t port = running.server.port();
    Visitor visitor(port);
    visitor.wait_for("rest", 0);
    const long before = peak_kilobytes();
    boost::asio::io_context context;
    std::vector<boost::asio::ip::tcp::socket> sockets;
    std::uint64_t id = 0;
    for (int i = 0; i < 1000; ++i) {
        sockets.emplace_back(context);
        sockets.back().connect({boost::asio::ip::address_v4::loopback(), port});
        if (i % 100 == 99) {
            visitor.send({{"do", "orbit"}, {"x", 3}, {"y", 0}, {"id", ++id}});
            visitor.wait_for("moving", id);
        }
    }
    // Those within the limit wait to be heard, some are told why they are not, the rest are hung up on.
    EXPECT_LT(peak_kilobytes() - before, 64 << 10);
    int told = 0;
    for (auto& socket : sockets) {
        const test::Watchdog watchdog(socket.native_handle());
        std::array<char, 64> start{};
        boost::system::error_code error;
        const std::size_t length = socket.read_some(boost::asio::buffer(start), error);
        told += std::string(start.data(), length).starts_with("HTTP/1.1 503 ") ? 1 : 0;
    }
    EXPECT_GT(told, 10);
    sockets.clear();
    visitor.send({{"do", "orbit"}, {"x", 3}, {"y", 0}, {"id", ++id}});
    visitor.wait_for("rest", id);
    // The old ones are gone, if not at once.
    for (int i = 0; i < 100 * testing::patience && !starts_with_status(get(port, "/"), 200); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_TRUE(starts_with_status(get(port, "/"), 200));
}

TEST(Server, SavesWhatTheCommandWrites)
{
    const Running running;
    Visitor visitor(running.server.port());
    visitor.send({{"do", "orbit"}, {"x", 12.345678}, {"y", 3.3}, {"id", 1}});
    visitor.send({{"do", "set"}, {"name", "tone"}, {"value", "agx"}, {"id", 2}});
    visitor.wait_for("rest", 2);
    visitor.send({{"do", "save"}, {"kind", "png"}});
    Visitor::Frame saved = visitor.next();
    while (saved.header.at("type") != "saved")
        saved = visitor.next();
    const testing::Folder folder;
    const std::string command = saved.header.at("command").get<std::string>().substr(7);
    const testing::Outcome outcome = testing::run_program(
        "/bin/sh", {"-c", "cd '" + folder.path("") + "' && " + std::string(LAMBENT_PROGRAM) + command});
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    std::ostringstream written;
    written << std::ifstream(folder.path("picture.png"), std::ios::binary).rdbuf();
    EXPECT_TRUE(written.str() == saved.picture);
}

TEST(Server, SaysWhyItCannotListen)
{
    const Running running;
    viewer::AssetCache assets({.cache = false});
    viewer::DrawScheduler scheduler(assets);
    ServerOptions options = Running::quick();
    options.host = "nonsense";
    EXPECT_THROW(Server(options, small_wish(), viewer::FileList({}), assets, scheduler), Error);
    EXPECT_TRUE(is_loopback("127.0.0.1") && is_loopback("::1") && is_loopback("localhost"));
    EXPECT_FALSE(is_loopback("0.0.0.0") || is_loopback("::") || is_loopback("192.168.0.1"));
    options.host = "127.0.0.1";
    options.port = running.server.port();
    try {
        const Server second(options, small_wish(), viewer::FileList({}), assets, scheduler);
        ADD_FAILURE() << "two servers at one port";
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::no_device);
    }
}

TEST(ServeCommand, AnotherMachineNeedsAToken)
{
    const testing::Outcome outcome = testing::run_program(
        LAMBENT_PROGRAM, {"serve", "plane", "--env", "none", "--host", "0.0.0.0", "--port", "0"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.error.find("--token"), std::string::npos);
    EXPECT_EQ(testing::run_program(LAMBENT_PROGRAM, {"serve", "nowhere.glb", "--port", "0"}).code, 3);
}

TEST(ServeCommand, SaysWhereItIsAndEndsWithTheSignal)
{
    const testing::Folder folder;
    const testing::Outcome outcome = testing::run_program(
        "/bin/sh", {"-c",
                    ": >\"$0\"; " + std::string(LAMBENT_PROGRAM) +
                        " serve plane --env none --port 0 > \"$0\" & pid=$!; while ! grep -q http \"$0\"; do "
                        "sleep 0.05; done; cat \"$0\"; kill -INT $pid; wait $pid",
                    folder.path("out")});
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_TRUE(outcome.output.starts_with("http://127.0.0.1:")) << outcome.output;
    EXPECT_EQ(outcome.error, "");
}

} // namespace
} // namespace lambent::serve
