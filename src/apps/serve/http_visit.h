// One HTTP connection: its request is answered, refused, or upgraded to a viewer's WebSocket.
#pragma once

#include "apps/serve/house.h"

#include <boost/asio/ip/tcp.hpp>

namespace lambent::serve {

/// Serves a new connection, and owns its socket until it ends.
void visit(const std::shared_ptr<House>& house, boost::asio::ip::tcp::socket socket);

} // namespace lambent::serve
