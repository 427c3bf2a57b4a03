#include "tests/serve/visitor.h"

#include "tests/support/process.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>

#include <chrono>

#include <sys/socket.h>

namespace lambent::serve::test {

namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;

namespace {

tcp::endpoint at(std::uint16_t port)
{
    return {asio::ip::address_v4::loopback(), port};
}

} // namespace

Watchdog::Watchdog(int socket)
    : thread_([this, socket] {
          std::unique_lock lock(mutex_);
          if (!ended_.wait_for(lock, std::chrono::seconds(30 * testing::patience),
                               [this] { return ending_; }))
              ::shutdown(socket, SHUT_RDWR);
      })
{
}

Watchdog::~Watchdog()
{
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    ended_.notify_all();
    thread_.join();
}

std::string ask(std::uint16_t port, const std::string& bytes)
{
    asio::io_context context;
    tcp::socket socket(context);
    socket.connect(at(port));
    const Watchdog watchdog(socket.native_handle());
    boost::system::error_code error;
    asio::write(socket, asio::buffer(bytes), error);
    std::string answer;
    asio::read(socket, asio::dynamic_buffer(answer), error);
    return answer;
}

std::string get(std::uint16_t port, const std::string& target, const std::string& lines)
{
    const std::string host = "Host: localhost:" + std::to_string(port) + "\r\n";
    return ask(port, "GET " + target + " HTTP/1.1\r\n" + host + lines + "\r\n");
}

Visitor::Visitor(std::uint16_t port, const std::string& target) : socket_(context_)
{
    socket_.next_layer().connect(at(port));
    watchdog_ = std::make_unique<Watchdog>(socket_.next_layer().native_handle());
    socket_.next_layer().set_option(tcp::no_delay(true)); // as browsers do
    socket_.handshake("localhost:" + std::to_string(port), target);
    socket_.read_message_max(std::size_t{256} << 20);
}

void Visitor::send_text(const std::string& message)
{
    socket_.text(true);
    socket_.write(asio::buffer(message));
}

void Visitor::send_bytes(const std::string& message)
{
    socket_.binary(true);
    socket_.write(asio::buffer(message));
}

Visitor::Frame Visitor::next()
{
    for (;;) {
        beast::flat_buffer buffer;
        socket_.read(buffer);
        if (socket_.got_text())
            continue;
        const std::string bytes = beast::buffers_to_string(buffer.data());
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i)
            length |= static_cast<std::size_t>(static_cast<unsigned char>(bytes.at(i))) << 8 * i;
        Frame frame{nlohmann::json::parse(bytes.substr(4, length)), bytes.substr(4 + length)};
        if (frame.header.at("type") == "frame")
            send({{"do", "seen"}});
        return frame;
    }
}

Visitor::Frame Visitor::wait_for(const std::string& kind, std::uint64_t input)
{
    for (;;) {
        Frame frame = next();
        if (frame.header.value("kind", "") == kind && frame.header.at("input").get<std::uint64_t>() >= input)
            return frame;
    }
}

nlohmann::json Visitor::wait_for_text(const std::string& type)
{
    for (;;) {
        beast::flat_buffer buffer;
        socket_.read(buffer);
        if (!socket_.got_text())
            continue;
        nlohmann::json message = nlohmann::json::parse(beast::buffers_to_string(buffer.data()));
        if (message.at("type") == type)
            return message;
    }
}

std::string Visitor::reason()
{
    boost::system::error_code error;
    while (!error) {
        beast::flat_buffer buffer;
        socket_.read(buffer, error);
    }
    const auto reason = socket_.reason().reason;
    return error == beast::websocket::error::closed ? std::string(reason.data(), reason.size())
                                                    : "no reason: " + error.message();
}

} // namespace lambent::serve::test
