#include "scene/gltf_uri.h"

#include "scene/gltf_message.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace lambent::scene {
namespace {

constexpr std::int8_t not_base64 = -1;

constexpr std::array<std::int8_t, 256> make_base64_values()
{
    std::array<std::int8_t, 256> values{};
    values.fill(not_base64);
    const std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < alphabet.size(); ++i)
        values[static_cast<unsigned char>(alphabet[i])] = static_cast<std::int8_t>(i);
    return values;
}

constexpr std::array<std::int8_t, 256> base64_values = make_base64_values();

std::vector<std::uint8_t> decode_base64(std::string_view code, const std::string& where)
{
    for (int padding = 0; padding < 2 && code.ends_with('='); ++padding)
        code.remove_suffix(1);
    if (code.size() % 4 == 1)
        refuse(where, ": base64 data is cut off");
    std::vector<std::uint8_t> bytes;
    bytes.reserve(code.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int held = 0;
    for (std::size_t i = 0; i < code.size(); ++i) {
        const std::int8_t value = base64_values[static_cast<unsigned char>(code[i])];
        if (value == not_base64)
            refuse(where, ": character ", i, " of the base64 data is not base64");
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        held += 6;
        if (held >= 8) {
            held -= 8;
            bytes.push_back(static_cast<std::uint8_t>(bits >> held));
        }
    }
    return bytes;
}

int hex_digit(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    const int lower = std::tolower(static_cast<unsigned char>(c));
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

// A `%` without two hexadecimal digits stands for itself: many exporters write plain file names.
std::string percent_decoded(std::string_view uri)
{
    std::string decoded;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0) {
            decoded += static_cast<char>(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2]));
            i += 2;
        } else {
            decoded += uri[i];
        }
    }
    std::replace(decoded.begin(), decoded.end(), '\\', '/');
    return decoded;
}

// "http:", "file:" and also "C:": a letter, then letters, digits, '+', '-', '.', before the first ':'.
bool has_scheme(std::string_view uri)
{
    const std::size_t colon = uri.find(':');
    if (colon == std::string_view::npos || colon == 0 || !std::isalpha(static_cast<unsigned char>(uri[0])))
        return false;
    return uri.substr(0, colon).find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                  "0123456789+-.") == std::string_view::npos;
}

} // namespace

bool is_data_uri(std::string_view uri)
{
    return uri.starts_with("data:");
}

std::vector<std::uint8_t> decode_data_uri(std::string_view uri, const std::string& where)
{
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64"))
        refuse(where, ": a data URI must be base64");
    return decode_base64(uri.substr(comma + 1), where);
}

std::filesystem::path relative_path(std::string_view uri, const std::string& where)
{
    const std::string decoded = percent_decoded(uri);
    const std::string shown = printable(decoded);
    if (has_scheme(uri))
        refuse(where, ": \"", shown, "\" is not a relative path");
    if (decoded.empty() || decoded.find('\0') != std::string::npos)
        refuse(where, ": the uri is not a file name");
    std::filesystem::path path = decoded;
    if (path.is_absolute())
        refuse(where, ": \"", shown, "\" is an absolute path; only files beside the glTF are read");
    int depth = 0;
    for (const auto& part : path) {
        if (part == "..")
            --depth;
        else if (part != "." && !part.empty())
            ++depth;
        if (depth < 0)
            refuse(where, ": \"", shown, "\" leaves the folder of the glTF");
    }
    return path;
}

} // namespace lambent::scene
