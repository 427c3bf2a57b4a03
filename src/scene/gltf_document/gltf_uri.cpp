#include "scene/gltf_document/gltf_uri.h"

#include "scene/gltf_document/gltf_message.h"

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

// The folders that the reach allows: those named, else the glTF's own.
std::vector<std::filesystem::path> folders_of(const UriBase& base)
{
    if (!base.reach.folders.empty() || !base.folder)
        return base.reach.folders;
    return {*base.folder};
}

std::filesystem::path normal(const std::filesystem::path& path)
{
    std::error_code error;
    std::filesystem::path whole =
        std::filesystem::absolute(path.empty() ? "." : path, error).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path(); // "folder/" is "folder"
}

// Both paths must be absolute and normal.
bool is_below(const std::filesystem::path& path, const std::filesystem::path& folder)
{
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
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

std::filesystem::path path_beside(const UriBase& base, std::string_view uri, const std::string& where)
{
    const std::string decoded = percent_decoded(uri);
    const std::string shown = printable(decoded);
    if (has_scheme(uri))
        refuse(where, ": \"", shown, "\" is not a relative path");
    if (decoded.empty() || decoded.find('\0') != std::string::npos)
        refuse(where, ": the uri is not a file name");
    const std::filesystem::path path = decoded;
    if (path.is_absolute())
        refuse(where, ": \"", shown, "\" is an absolute path; only relative ones are read");
    if (!base.folder)
        refuse(where, ": \"", shown, "\" is an external file; only embedded data is read");
    const std::filesystem::path found = *base.folder / path.lexically_normal();
    if (base.reach.anywhere)
        return found;
    const std::filesystem::path whole = normal(found);
    const std::vector<std::filesystem::path> folders = folders_of(base);
    if (std::none_of(folders.begin(), folders.end(),
                     [&](const auto& folder) { return is_below(whole, normal(folder)); }))
        refuse(where, ": \"", shown, "\" leaves the folder",
               base.reach.folders.empty() ? " of the glTF" : "s that may be read");
    return found;
}

void check_links(const UriBase& base, const std::filesystem::path& path, const std::string& where)
{
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(path, error);
    if (base.reach.anywhere || error) // a missing file is reported when it is read
        return;
    for (const std::filesystem::path& folder : folders_of(base)) {
        const std::filesystem::path real_folder = std::filesystem::canonical(normal(folder), error);
        if (!error && is_below(real, real_folder))
            return;
    }
    refuse(where, ": \"", printable(path.string()), "\" is a link that leads out of the folder",
           base.reach.folders.empty() ? " of the glTF" : "s that may be read");
}

} // namespace lambent::scene
