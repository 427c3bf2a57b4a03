// One browser: a session and its WebSocket.
#pragma once

#include "apps/serve/server_state.h"

#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>

namespace lambent::serve {

using UpgradeRequest = boost::beast::http::request<boost::beast::http::empty_body>;

/// Accepts the upgrade and serves the viewer until either side closes the connection.
void start_viewer(std::shared_ptr<ServerState> server, boost::beast::tcp_stream stream,
                  UpgradeRequest request, Counted<int> connection);

} // namespace lambent::serve
