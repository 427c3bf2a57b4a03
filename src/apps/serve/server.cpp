#include "apps/serve/server.h"

#include "apps/serve/http_connection.h"
#include "base/error.h"
#include "base/text.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>

#include <csignal>
#include <optional>

namespace lambent::serve {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

asio::ip::address address_of(const std::string& host)
{
    if (host == "localhost")
        return asio::ip::address_v4::loopback();
    boost::system::error_code error;
    asio::ip::address address = asio::ip::make_address(host, error);
    if (error)
        throw Error(Failure::usage,
                    text("--host: '", one_line(host), "' is not a numeric address such as 127.0.0.1 or ::"));
    return address;
}

// Percent-encodes the token, which may be any text, for a URL.
std::string encoded(const std::string& word)
{
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string result;
    for (const char c : word) {
        const auto code = static_cast<unsigned char>(c);
        const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           c == '-' || c == '_' || c == '.' || c == '~';
        result += plain ? std::string(1, c) : std::string{'%', digits[code >> 4], digits[code & 15]};
    }
    return result;
}

} // namespace

bool is_loopback(const std::string& host)
{
    return address_of(host).is_loopback();
}

class Server::Impl {
public:
    Impl(ServerOptions options, viewer::ViewRequest start, viewer::FileList files, viewer::AssetCache& assets,
         viewer::DrawScheduler& scheduler)
        : state_(
              new ServerState{std::move(options), std::move(start), std::move(files), assets, scheduler, {}}),
          acceptor_(context_), pause_(context_)
    {
        const asio::ip::address address = address_of(state_->options.host);
        const tcp::endpoint endpoint(address, state_->options.port);
        state_->gate = {address.to_string(), address.is_loopback(), state_->options.token};
        try {
            acceptor_.open(endpoint.protocol());
            acceptor_.set_option(asio::socket_base::reuse_address(true));
            acceptor_.bind(endpoint);
            acceptor_.listen(asio::socket_base::max_listen_connections);
        } catch (const boost::system::system_error& error) {
            throw Error(Failure::no_device, text("cannot listen at ", state_->options.host, " port ",
                                                 state_->options.port, ": ", error.code().message()));
        }
        accept();
    }

    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    // The scheduler must stop first, as presenters post to context_.
    ~Impl() { state_->scheduler.stop(); }

    std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

    std::string url() const
    {
        const asio::ip::address address = acceptor_.local_endpoint().address();
        const std::string name = address.is_v6() ? text("[", address.to_string(), "]") : address.to_string();
        const std::string& token = state_->options.token;
        return text("http://", name, ":", port(), "/", token.empty() ? "" : text("?token=", encoded(token)));
    }

    void run() { context_.run(); }

    void stop() { context_.stop(); }

    void stop_on_signals()
    {
        signals_.emplace(context_, SIGINT, SIGTERM);
        signals_->async_wait([this](boost::system::error_code error, int) {
            if (!error)
                stop();
        });
    }

    int sessions() const { return state_->sessions; }

private:
    void accept()
    {
        acceptor_.async_accept([this](boost::system::error_code error, tcp::socket socket) {
            if (!error) {
                serve_connection(state_, std::move(socket));
                return accept();
            }
            if (error == asio::error::operation_aborted)
                return;
            // Most likely there are no free file descriptors: accepting is tried again later.
            pause_.expires_after(std::chrono::milliseconds(50));
            pause_.async_wait([this](boost::system::error_code) { accept(); });
        });
    }

    std::shared_ptr<ServerState> state_;
    asio::io_context context_{1};
    tcp::acceptor acceptor_;
    asio::steady_timer pause_;
    std::optional<asio::signal_set> signals_;
};

Server::Server(ServerOptions options, viewer::ViewRequest start, viewer::FileList files,
               viewer::AssetCache& assets, viewer::DrawScheduler& scheduler)
    : impl_(std::make_unique<Impl>(std::move(options), std::move(start), std::move(files), assets, scheduler))
{
}

Server::~Server() = default;

std::uint16_t Server::port() const
{
    return impl_->port();
}

std::string Server::url() const
{
    return impl_->url();
}

void Server::run()
{
    impl_->run();
}

void Server::stop()
{
    impl_->stop();
}

void Server::stop_on_signals()
{
    impl_->stop_on_signals();
}

int Server::sessions() const
{
    return impl_->sessions();
}

} // namespace lambent::serve
