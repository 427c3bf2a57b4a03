// Access control for requests, independent of sockets.
#pragma once

#include <string>
#include <string_view>

namespace lambent::serve {

/// The headers and the target of a request that access depends on.
struct Visitor {
    std::string_view host;          ///< header Host
    std::string_view origin;        ///< header Origin, which browsers send
    std::string_view authorization; ///< header Authorization
    std::string_view target;        ///< path and query
};

/// Why a request is refused.
struct Refusal {
    unsigned status = 0; ///< of HTTP; 0: the request is allowed
    std::string reason;  ///< one line for the user
};

/// The rules of one server.
struct Gate {
    std::string address;  ///< that the server listens at, without port
    bool loopback = true; ///< whether only this machine can reach the address
    std::string token;    ///< empty: no token is needed

    /// Keeps pages of other sites from reaching the server through a user's browser: on a loopback address the Host
    /// must be a name of this machine (against DNS rebinding), and the Origin, if any, must match the Host. Then checks
    /// the token.
    Refusal check(const Visitor& visitor) const;
};

/// Whether two texts are equal, in a time that depends on the length of `given` only.
bool equal_in_constant_time(std::string_view given, std::string_view secret);

/// The percent-decoded value of a name in the query of a target; empty if the name is missing.
std::string query_value(std::string_view target, std::string_view name);

/// The target without its query.
std::string_view path_of(std::string_view target);

} // namespace lambent::serve
