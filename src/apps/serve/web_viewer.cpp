#include "apps/serve/web_viewer.h"

#include "apps/common/picture_audit.h"
#include "apps/serve/link.h"
#include "apps/serve/messages.h"
#include "base/error.h"
#include "base/text.h"
#include "image/codes/jpeg.h"
#include "image/codes/png.h"

#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>

#include <deque>

namespace lambent::serve {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using viewer::Clock;
using viewer::ShownPicture;

class WebViewer;

// Encodes on the drawing thread, which calls it, and posts the bytes to the serving thread.
class WebPresenter : public viewer::Presenter {
public:
    explicit WebPresenter(asio::any_io_executor executor) : executor_(std::move(executor)) {}

    /// Called once by the serving thread, before the session is drawn.
    void set_viewer(std::weak_ptr<WebViewer> viewer) { viewer_ = std::move(viewer); }

    void show(ShownPicture picture) override;
    void say(const std::string& state) override;
    void save(viewer::Saved saved) override;

    std::atomic<int> quality = 75;

private:
    void hand_over(std::vector<std::uint8_t> bytes, bool is_text, bool is_frame);

    asio::any_io_executor executor_;
    std::weak_ptr<WebViewer> viewer_;
};

struct Outgoing {
    std::vector<std::uint8_t> bytes;
    bool is_text = false, is_frame = false;
};

class WebViewer : public std::enable_shared_from_this<WebViewer> {
public:
    WebViewer(std::shared_ptr<ServerState> server, beast::tcp_stream stream, Counted<int> connection)
        : server_(std::move(server)), connection_(std::move(connection)), seat_(server_->sessions),
          socket_(std::move(stream)), presenter_(std::make_shared<WebPresenter>(socket_.get_executor()))
    {
    }

    ~WebViewer()
    {
        if (session_)
            server_->scheduler.remove(session_);
    }

    void start(UpgradeRequest request)
    {
        const Limits& limits = server_->options.limits;
        beast::get_lowest_layer(socket_).expires_never();
        beast::get_lowest_layer(socket_).socket().set_option(asio::ip::tcp::no_delay(true));
        socket_.set_option(websocket::stream_base::timeout{std::chrono::seconds(limits.request_seconds),
                                                           std::chrono::seconds(limits.idle_seconds), true});
        socket_.read_message_max(limits.message_bytes);
        socket_.auto_fragment(false);
        request_ = std::move(request);
        socket_.async_accept(request_, [self = shared_from_this()](beast::error_code error) {
            if (!error)
                self->begin();
        });
    }

    void send(Outgoing message)
    {
        if (ending_)
            return;
        backlog_ += message.bytes.size();
        outgoing_.push_back(std::move(message));
        if (backlog_ > server_->options.limits.backlog_bytes)
            return hang_up();
        if (outgoing_.size() == 1)
            write();
    }

private:
    void begin()
    {
        presenter_->set_viewer(weak_from_this());
        session_ = std::make_shared<viewer::Session>(server_->start, server_->assets, presenter_);
        send_text(hello(server_->files));
        server_->scheduler.add(session_);
        read();
    }

    void send_text(const std::string& message) { send({{message.begin(), message.end()}, true, false}); }

    void read()
    {
        buffer_.clear();
        socket_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
            if (!error)
                self->got();
            else
                self->hang_up(); // also for too large messages, for which the stream has sent a close frame
        });
    }

    void got()
    {
        if (ending_)
            return read(); // discarded until the client closes as well
        if (!socket_.got_text())
            return close(websocket::close_code::unknown_data, "messages must be text");
        if (is_flood())
            return close(websocket::close_code::policy_error, "too many messages");
        try {
            const auto bytes = buffer_.data();
            const std::string_view message(static_cast<const char*>(bytes.data()), bytes.size());
            if (handle_message(message, *session_, server_->files) == MessageKind::seen)
                note_seen();
            server_->scheduler.nudge();
        } catch (const Malformed& malformed) {
            return close(websocket::close_code::bad_payload, malformed.what());
        } catch (const Error& error) {
            send_text(error_message(error.what()));
        }
        read();
    }

    bool is_flood()
    {
        const Clock::time_point now = Clock::now();
        if (now - second_ > std::chrono::seconds(1)) {
            second_ = now;
            heard_ = 0;
        }
        return ++heard_ > server_->options.limits.messages_per_second;
    }

    void note_seen()
    {
        if (sent_.empty())
            return;
        link_.seen(std::chrono::duration<double, std::milli>(Clock::now() - sent_.front()).count());
        sent_.pop_front();
        presenter_->quality = link_.quality();
    }

    void write()
    {
        const Outgoing& message = outgoing_.front();
        if (message.is_frame)
            sent_.push_back(Clock::now());
        socket_.text(message.is_text);
        socket_.async_write(asio::buffer(message.bytes),
                            [self = shared_from_this()](beast::error_code error, std::size_t) {
                                if (error)
                                    self->hang_up();
                                else
                                    self->written();
                            });
    }

    void written()
    {
        backlog_ -= outgoing_.front().bytes.size();
        outgoing_.pop_front();
        if (!outgoing_.empty() && !ending_)
            write();
    }

    void close(websocket::close_code code, const std::string& reason)
    {
        ending_ = true;
        session_->close();
        // A close frame has at most 123 bytes for the reason.
        socket_.async_close(websocket::close_reason(code, reason.substr(0, 120)),
                            [self = shared_from_this()](beast::error_code) {});
    }

    void hang_up()
    {
        ending_ = true;
        session_->close();
        beast::close_socket(beast::get_lowest_layer(socket_));
    }

    std::shared_ptr<ServerState> server_;
    Counted<int> connection_;
    Counted<std::atomic<int>> seat_;
    websocket::stream<beast::tcp_stream, false> socket_;
    std::shared_ptr<WebPresenter> presenter_;
    std::shared_ptr<viewer::Session> session_;
    UpgradeRequest request_;
    beast::flat_buffer buffer_;
    std::deque<Outgoing> outgoing_;
    std::size_t backlog_ = 0;
    std::deque<Clock::time_point> sent_; ///< when the frames were sent that are not yet seen
    Link link_;
    Clock::time_point second_{};
    int heard_ = 0;
    bool ending_ = false;
};

void WebPresenter::hand_over(std::vector<std::uint8_t> bytes, bool is_text, bool is_frame)
{
    asio::post(executor_,
               [viewer = viewer_, message = Outgoing{std::move(bytes), is_text, is_frame}]() mutable {
                   if (const std::shared_ptr<WebViewer> there = viewer.lock())
                       there->send(std::move(message));
               });
}

void WebPresenter::show(ShownPicture picture)
{
    using Kind = ShownPicture::Kind;
    // Moving views and unfinished traces will soon be replaced: they are sent as JPEG, all others without loss.
    const bool lossy = picture.kind == Kind::moving || (picture.kind == Kind::traced && !picture.is_last);
    nlohmann::ordered_json header = {{"type", "frame"},
                                     {"kind", viewer::name_of(picture.kind)},
                                     {"format", lossy ? "jpeg" : "png"},
                                     {"width", picture.width},
                                     {"height", picture.height},
                                     {"scale", picture.scale},
                                     {"draw_ms", picture.draw_ms},
                                     {"input", picture.input},
                                     {"moment", picture.moment},
                                     {"last", picture.is_last}};
    if (picture.lacks_shadows)
        header["lacks_shadows"] = true;
    if (picture.error)
        header["error"] = cli::to_json(*picture.error);
    if (const std::optional<ShownPicture::Traced>& traced = picture.traced) {
        header["traced"] = {{"samples", traced->samples}, {"error", traced->error}};
        if (traced->noise)
            header["traced"]["noise"] = *traced->noise;
        if (traced->flip)
            header["traced"]["flip"] = *traced->flip;
    }
    const std::vector<std::uint8_t> bytes =
        lossy ? image::encode_jpeg(picture.codes, {quality, true}) : image::encode_png(picture.codes);
    hand_over(frame_message(header.dump(), bytes), false, true);
}

void WebPresenter::say(const std::string& state)
{
    hand_over({state.begin(), state.end()}, true, false);
}

void WebPresenter::save(viewer::Saved saved)
{
    const nlohmann::ordered_json header = {
        {"type", "saved"}, {"name", saved.name}, {"command", saved.command}};
    const std::string text = header.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    hand_over(frame_message(text, saved.bytes), false, false);
}

} // namespace

void start_viewer(std::shared_ptr<ServerState> server, beast::tcp_stream stream, UpgradeRequest request,
                  Counted<int> connection)
{
    std::make_shared<WebViewer>(std::move(server), std::move(stream), std::move(connection))
        ->start(std::move(request));
}

} // namespace lambent::serve
