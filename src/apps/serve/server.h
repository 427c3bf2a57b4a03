// The viewer over HTTP and WebSocket.
#pragma once

#include "apps/viewer/file_list.h"
#include "apps/viewer/draw_scheduler.h"

#include <cstdint>
#include <memory>
#include <string>

namespace lambent::serve {

/// What a server bears at once. Whatever is beyond is refused with a reason.
struct Limits {
    int sessions = 8;     ///< viewers
    int connections = 64; ///< of any kind, viewers included
    std::size_t message_bytes = 8192;
    std::size_t header_bytes = 8192;
    std::size_t backlog_bytes = std::size_t{48} << 20; ///< not yet sent to one viewer
    int messages_per_second = 1000;                    ///< from one viewer
    int request_seconds = 10;                          ///< until a request is complete
    int idle_seconds = 30;                             ///< without a sign of life of a viewer
};

struct ServerOptions {
    std::string host = "127.0.0.1"; ///< an address, or localhost
    std::uint16_t port = 8080;      ///< 0: any that is free
    std::string token;              ///< empty: none
    Limits limits;
};

/// Whether it is an address that only this machine reaches. Throws Error(usage) if it is no address.
bool is_loopback(const std::string& host);

class Server {
public:
    /// Listens. `start` is what each viewer sees first. The assets and the scheduler must outlive it; the scheduler is stopped at
    /// its end.
    /// Throws Error(usage) for a host that is no address, Error(no_device) if the port cannot be had.
    Server(ServerOptions options, viewer::ViewRequest start, viewer::FileList files,
           viewer::AssetCache& assets, viewer::DrawScheduler& scheduler);
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    ~Server();

    std::uint16_t port() const;

    /// For a browser: with the token, if there is one.
    std::string url() const;

    /// Serves in the calling thread until stop().
    void run();

    /// Ends run(). Any thread.
    void stop();

    /// SIGINT and SIGTERM are stop() from now on.
    void stop_on_signals();

    /// Viewers at the moment. Any thread.
    int sessions() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace lambent::serve
