// One connection: a request is answered, refused, or becomes a viewer's.
#pragma once

#include "apps/serve/house.h"

#include <boost/asio/ip/tcp.hpp>

namespace lambent::serve {

/// Serves a new connection, whose socket it keeps until it is over.
void visit(const std::shared_ptr<House>& house, boost::asio::ip::tcp::socket socket);

} // namespace lambent::serve
