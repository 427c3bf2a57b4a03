// Clients of a server, well behaved and not, that never wait for ever.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/websocket.hpp>

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include <nlohmann/json.hpp>

namespace lambent::serve::test {

/// Hangs up after 30 s, so that what waits for an answer fails.
class Watchdog {
public:
    explicit Watchdog(int socket);
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;
    ~Watchdog();

private:
    std::mutex mutex_;
    std::condition_variable ended_;
    bool ending_ = false;
    std::thread thread_;
};

/// Sends the bytes and returns everything that comes back until the server hangs up.
std::string ask(std::uint16_t port, const std::string& bytes);

/// "GET target" with the header Host that is expected, and further header lines.
std::string get(std::uint16_t port, const std::string& target, const std::string& lines = "");

/// A browser: a WebSocket on which pictures come.
class Visitor {
public:
    /// Throws boost::system::system_error if it is refused.
    explicit Visitor(std::uint16_t port, const std::string& target = "/socket");

    void send(const nlohmann::json& message) { send_text(message.dump()); }
    void send_text(const std::string& message);
    void send_bytes(const std::string& message);

    struct Frame {
        nlohmann::json header;
        std::string picture;
    };

    /// The next frame or file, texts before it are kept; says that it was seen.
    Frame next();

    /// The next frame of this kind that shows this input.
    Frame wait_for(const std::string& kind, std::uint64_t input);

    /// The next text of this type.
    nlohmann::json wait_for_text(const std::string& type);

    /// Reads until the server ends it; its reason.
    std::string reason();

private:
    boost::asio::io_context context_;
    boost::beast::websocket::stream<boost::asio::ip::tcp::socket> socket_;
    std::unique_ptr<Watchdog> watchdog_;
};

} // namespace lambent::serve::test
