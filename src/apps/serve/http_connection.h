// One HTTP connection: its request is answered, refused, or upgraded to a viewer's WebSocket.
#pragma once

#include "apps/serve/server_state.h"

#include <boost/asio/ip/tcp.hpp>

namespace lambent::serve {

/// Serves a new connection, and owns its socket until it ends.
void serve_connection(const std::shared_ptr<ServerState>& server, boost::asio::ip::tcp::socket socket);

} // namespace lambent::serve
