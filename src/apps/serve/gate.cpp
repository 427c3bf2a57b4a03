#include "apps/serve/gate.h"

#include "base/text.h"

#include <charconv>

namespace lambent::serve {
namespace {

// The host without its port: "[::1]" of "[::1]:8080"; "?" where the port is not a number.
std::string_view name_of(std::string_view host)
{
    const std::size_t bracket = host.rfind(']'), colon = host.rfind(':');
    const bool has_port = colon != std::string_view::npos &&
                          (bracket == std::string_view::npos ? host.find(':') == colon : colon > bracket);
    if (!has_port)
        return host;
    const bool is_number = host.find_first_not_of("0123456789", colon + 1) == std::string_view::npos;
    return is_number ? host.substr(0, colon) : "?";
}

std::string_view unbracketed(std::string_view name)
{
    return name.starts_with('[') && name.ends_with(']') ? name.substr(1, name.size() - 2) : name;
}

std::string decoded(std::string_view word)
{
    std::string result;
    for (std::size_t i = 0; i < word.size(); ++i) {
        int code = 0;
        const char* const digits = word.data() + i + 1;
        if (word[i] == '%' && word.size() - i > 2 &&
            std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
            result += static_cast<char>(code);
            i += 2;
        } else {
            result += word[i] == '+' ? ' ' : word[i];
        }
    }
    return result;
}

} // namespace

bool equal_in_constant_time(std::string_view given, std::string_view secret)
{
    unsigned different = given.size() == secret.size() ? 0u : 1u;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const char other = secret.empty() ? '\0' : secret[i % secret.size()];
        different |= static_cast<unsigned char>(given[i] ^ other);
    }
    return different == 0;
}

std::string_view path_of(std::string_view target)
{
    return target.substr(0, target.find('?'));
}

std::string query_value(std::string_view target, std::string_view name)
{
    const std::size_t question = target.find('?');
    std::string_view rest = question == std::string_view::npos ? "" : target.substr(question + 1);
    while (!rest.empty()) {
        const std::size_t end = rest.find('&');
        const std::string_view pair = rest.substr(0, end);
        if (pair.starts_with(name) && pair.substr(name.size()).starts_with('='))
            return decoded(pair.substr(name.size() + 1));
        rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
    }
    return {};
}

Refusal Gate::check(const Visitor& visitor) const
{
    const std::string_view name = unbracketed(name_of(visitor.host));
    if (name.empty())
        return {400, "the header Host is missing"};
    if (loopback && name != "localhost" && name != "127.0.0.1" && name != "::1" && name != address)
        return {403, "the header Host names another machine"};
    if (!visitor.origin.empty() && visitor.origin != text("http://", visitor.host) &&
        visitor.origin != text("https://", visitor.host))
        return {403, "the header Origin names another site"};
    constexpr std::string_view bearer = "Bearer ";
    const std::string given = visitor.authorization.starts_with(bearer)
                                  ? std::string(visitor.authorization.substr(bearer.size()))
                                  : query_value(visitor.target, "token");
    if (!token.empty() && !equal_in_constant_time(given, token))
        return {401,
                given.empty() ? "a token is required: add ?token=... to the address" : "the token is wrong"};
    return {};
}

} // namespace lambent::serve
