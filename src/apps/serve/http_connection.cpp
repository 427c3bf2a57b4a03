#include "apps/serve/http_connection.h"

#include "apps/serve/page.h"
#include "apps/serve/web_viewer.h"
#include "base/text.h"

#include <boost/asio/buffer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <array>
#include <optional>

namespace lambent::serve {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;

// How long a client has to read its answer and close the connection.
constexpr std::chrono::seconds leave_time{1};

std::string_view view(beast::string_view text)
{
    return {text.data(), text.size()};
}

class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
public:
    HttpConnection(std::shared_ptr<ServerState> server, tcp::socket socket)
        : server_(std::move(server)), stream_(std::move(socket)), seat_(server_->connections)
    {
        parser_.header_limit(static_cast<std::uint32_t>(server_->options.limits.header_bytes));
        parser_.body_limit(0);
    }

    void read()
    {
        stream_.expires_after(std::chrono::seconds(server_->options.limits.request_seconds));
        http::async_read(
            stream_, buffer_, parser_,
            [self = shared_from_this()](beast::error_code error, std::size_t) { self->got(error); });
    }

    void refuse(http::status status, const std::string& reason)
    {
        answer(status, "text/plain; charset=utf-8", text(reason, "\n"));
    }

private:
    void got(beast::error_code error)
    {
        if (error == http::error::header_limit)
            return refuse(http::status::request_header_fields_too_large, "the request's header is too large");
        if (error == http::error::body_limit)
            return refuse(http::status::payload_too_large, "requests with a body are not accepted");
        if (error == beast::error::timeout || error == http::error::end_of_stream)
            return; // the client has gone; the stream closes itself
        if (error)
            return error.category() == http::make_error_code(http::error::bad_method).category()
                       ? refuse(http::status::bad_request,
                                text("not a valid HTTP request: ", error.message()))
                       : void();
        const http::request<http::empty_body>& request = parser_.get();
        const Refusal refusal =
            server_->gate.check({view(request[http::field::host]), view(request[http::field::origin]),
                                 view(request[http::field::authorization]), view(request.target())});
        if (refusal.status != 0)
            return refuse(http::int_to_status(refusal.status), refusal.reason);
        if (request.method() != http::verb::get)
            return refuse(http::status::method_not_allowed, "only GET is supported");
        route(view(path_of(view(request.target()))));
    }

    static std::string_view view(std::string_view text) { return text; }
    static std::string_view view(beast::string_view text) { return serve::view(text); }

    void route(std::string_view path)
    {
        const bool upgrade = beast::websocket::is_upgrade(parser_.get());
        if (path == "/socket" && upgrade) {
            if (server_->sessions >= server_->options.limits.sessions)
                return refuse(http::status::service_unavailable,
                              text("the limit of ", server_->options.limits.sessions, " viewers is reached"));
            start_viewer(server_, std::move(stream_), parser_.release(), std::move(seat_));
        } else if (path == "/socket") {
            refuse(http::status::upgrade_required, "/socket is for WebSocket connections only");
        } else if (path == "/") {
            answer(http::status::ok, "text/html; charset=utf-8", std::string(page_html));
        } else {
            refuse(http::status::not_found, "nothing is served at this path");
        }
    }

    void answer(http::status status, const char* type, std::string body)
    {
        response_.emplace(status, 11);
        response_->set(http::field::server, "lambent");
        response_->set(http::field::content_type, type);
        response_->set(http::field::cache_control, "no-store");
        response_->set("Content-Security-Policy",
                       "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
                       "img-src data: blob:; connect-src 'self'; frame-ancestors 'none'; base-uri 'none'; "
                       "form-action 'none'");
        response_->set("X-Content-Type-Options", "nosniff");
        response_->set("Referrer-Policy", "no-referrer");
        if (status == http::status::method_not_allowed)
            response_->set(http::field::allow, "GET");
        if (status == http::status::unauthorized)
            response_->set(http::field::www_authenticate, "Bearer");
        response_->keep_alive(false);
        response_->body() = std::move(body);
        response_->prepare_payload();
        stream_.expires_after(std::chrono::seconds(server_->options.limits.request_seconds));
        http::async_write(stream_, *response_,
                          [self = shared_from_this()](beast::error_code error, std::size_t) {
                              if (!error)
                                  self->leave();
                          });
    }

    // Reads and discards what the client still sends: closing with unread data would reset the connection and could
    // lose the answer.
    void leave()
    {
        beast::error_code error;
        stream_.socket().shutdown(tcp::socket::shutdown_send, error);
        stream_.expires_after(leave_time);
        drain();
    }

    void drain()
    {
        // The deadline is not extended, so that a client that keeps sending is cut off.
        stream_.async_read_some(asio::buffer(rest_),
                                [self = shared_from_this()](beast::error_code error, std::size_t) {
                                    if (!error)
                                        self->drain();
                                });
    }

    std::shared_ptr<ServerState> server_;
    beast::tcp_stream stream_;
    Counted<int> seat_;
    beast::flat_buffer buffer_{64 << 10};
    http::request_parser<http::empty_body> parser_;
    std::optional<http::response<http::string_body>> response_;
    std::array<char, 4096> rest_{};
};

} // namespace

void serve_connection(const std::shared_ptr<ServerState>& server, tcp::socket socket)
{
    // Beyond twice the limit connections are closed without an answer.
    const int most = server->options.limits.connections;
    if (server->connections >= 2 * most)
        return;
    const bool full = server->connections >= most;
    const auto connection = std::make_shared<HttpConnection>(server, std::move(socket));
    if (full)
        connection->refuse(boost::beast::http::status::service_unavailable, "too many connections");
    else
        connection->read();
}

} // namespace lambent::serve
