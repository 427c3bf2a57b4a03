// Who may come in: nothing here knows a socket.
#pragma once

#include <string>
#include <string_view>

namespace lambent::serve {

/// What a request says about where it comes from.
struct Visitor {
    std::string_view host;          ///< header Host
    std::string_view origin;        ///< header Origin; browsers send it
    std::string_view authorization; ///< header Authorization
    std::string_view target;        ///< path and query
};

/// Why a request is refused: a status of HTTP and a line for people; 0: it is not.
struct Refusal {
    unsigned status = 0;
    std::string reason;
};

struct Gate {
    std::string address; ///< that is listened at, without port
    bool loopback = true;
    std::string token; ///< empty: none is needed

    /// A page of another site must not reach the server through somebody's browser: the Host must be a name of this
    /// machine where only this machine listens, and the Origin, if any, must be the Host's.
    Refusal check(const Visitor& visitor) const;
};

/// Whether two texts are equal, in a time that only depends on the length of `given`.
bool equal_in_constant_time(std::string_view given, std::string_view secret);

/// The value of a name in the query of a target, percent-decoded; empty if it is not there.
std::string query_value(std::string_view target, std::string_view name);

/// The target without its query.
std::string_view path_of(std::string_view target);

} // namespace lambent::serve
