#include "apps/report/html.h"

#include <cmath>
#include <cstdio>

namespace lambent::report {
namespace {

bool is_letter_or_digit(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

std::string escaped(char c)
{
    switch (c) {
    case '&':
        return "&amp;";
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '"':
        return "&quot;";
    case '\'':
        return "&#39;";
    default:
        break;
    }
    // HTML allows no other control characters.
    const bool is_control = static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t';
    return is_control || c == 0x7f ? "\uFFFD" : std::string(1, c);
}

// `html` must be escaped already.
std::string enclosed(std::string_view tag, std::string_view html)
{
    std::string all = "<";
    all.append(tag).append(">").append(html).append("</");
    return all.append(tag.substr(0, tag.find(' '))).append(">");
}

} // namespace

std::string escape(std::string_view text)
{
    std::string html;
    html.reserve(text.size());
    for (const char c : text)
        html += escaped(c);
    return html;
}

std::string address(std::string_view file)
{
    // "//host" would name another machine. A colon, which would end a scheme, is encoded below.
    std::string text = file.starts_with('/') ? "." : "";
    for (const char c : file) {
        if (is_letter_or_digit(c) || std::string_view("-._~/").find(c) != std::string_view::npos) {
            text += c;
            continue;
        }
        char code[4];
        std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
        text += code;
    }
    return text;
}

std::string attribute(std::string_view name, std::string_view value)
{
    std::string html = " ";
    return html.append(name).append("=\"").append(escape(value)).append("\"");
}

std::string element(std::string_view tag, std::string_view text)
{
    return enclosed(tag, escape(text));
}

std::string prose(std::string_view tag, std::string_view text)
{
    std::string html;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t option = text.find("--", at);
        if (option == std::string_view::npos)
            return enclosed(tag, html + escape(text.substr(at)));
        std::size_t end = option + 2;
        while (end < text.size() && (is_letter_or_digit(text[end]) || text[end] == '-'))
            ++end;
        html += escape(text.substr(at, option - at)) +
                element("code class=\"option\"", text.substr(option, end - option));
        at = end;
    }
    return enclosed(tag, html);
}

std::string decimal(double value)
{
    char text[32];
    const long hundredths = std::lround(value * 100);
    const char* sign = hundredths < 0 ? "-" : "";
    std::snprintf(text, sizeof text, "%s%ld.%02ld", sign, std::labs(hundredths) / 100,
                  std::labs(hundredths) % 100);
    std::string short_text = text;
    while (short_text.back() == '0')
        short_text.pop_back();
    if (short_text.back() == '.')
        short_text.pop_back();
    return short_text;
}

std::string Ids::take(std::string_view wanted)
{
    std::string id;
    for (const char c : wanted)
        id += is_letter_or_digit(c) || c == '-' || c == '_' ? c : '-';
    if (id.empty())
        id = "part";
    std::string unique = id;
    for (int i = 2; !taken_.insert(unique).second; ++i)
        unique = id + "-" + std::to_string(i);
    return unique;
}

} // namespace lambent::report
