// The viewer over HTTP and WebSocket.
#pragma once

#include "apps/viewer/file_list.h"
#include "apps/viewer/draw_scheduler.h"

#include <cstdint>
#include <memory>
#include <string>

namespace lambent::serve {

/// Limits of a server. What exceeds them is refused with a reason.
struct Limits {
    int sessions = 8;     ///< viewers
    int connections = 64; ///< of any kind, viewers included
    std::size_t message_bytes = 8192;
    std::size_t header_bytes = 8192;
    std::size_t backlog_bytes = std::size_t{48} << 20; ///< queued for one viewer
    int messages_per_second = 1000;                    ///< from one viewer
    int request_seconds = 10;                          ///< until a request is complete
    int idle_seconds = 30;                             ///< without any data from a viewer, pongs included
};

struct ServerOptions {
    std::string host = "127.0.0.1"; ///< a numeric address, or "localhost"
    std::uint16_t port = 8080;      ///< 0: any free port
    std::string token;              ///< empty: no token is needed
    Limits limits;
};

/// Whether only this machine can reach the address. Throws Error(usage) if it is not an address.
bool is_loopback(const std::string& host);

class Server {
public:
    /// Listens. `start` is the first request of each viewer. The assets and the scheduler must outlive the server,
    /// whose destructor stops the scheduler. Throws Error(usage) if the host is not an address, Error(no_device) if the
    /// port cannot be used.
    Server(ServerOptions options, viewer::ViewRequest start, viewer::FileList files,
           viewer::AssetCache& assets, viewer::DrawScheduler& scheduler);
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    ~Server();

    std::uint16_t port() const;

    /// The address for a browser, with the token if there is one.
    std::string url() const;

    /// Serves in the calling thread until stop().
    void run();

    /// Ends run(). Any thread.
    void stop();

    /// Lets SIGINT and SIGTERM call stop().
    void stop_on_signals();

    /// The number of viewers now. Any thread.
    int sessions() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace lambent::serve
