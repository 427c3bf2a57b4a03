#include "apps/view/window_settings.h"

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"

#include <nlohmann/json.hpp>

#include <cstdlib>

namespace lambent::view_window {
namespace {

constexpr int version = 1, least_side = 320, most_side = 16384;
constexpr std::size_t most_bytes = 65536;

std::optional<int> number(const nlohmann::json& json, const char* name, int least)
{
    const auto found = json.find(name);
    if (found == json.end() || !found->is_number_integer())
        return std::nullopt;
    const auto value = found->get<std::int64_t>();
    return value >= least && value <= most_side ? std::optional(static_cast<int>(value)) : std::nullopt;
}

void read_flag(const nlohmann::json& json, const char* name, bool& flag)
{
    if (const auto found = json.find(name); found != json.end() && found->is_boolean())
        flag = found->get<bool>();
}

} // namespace

std::optional<std::filesystem::path> settings_file()
{
    const std::filesystem::path name = "lambent/view.json";
    if (const char* folder = std::getenv("XDG_CONFIG_HOME"); folder && folder[0] == '/')
        return folder / name;
    if (const char* home = std::getenv("HOME"); home && home[0] == '/')
        return std::filesystem::path(home) / ".config" / name;
    return std::nullopt;
}

WindowSettings read_settings(const std::string& json, std::string& complaint)
{
    WindowSettings settings;
    const nlohmann::json parsed = nlohmann::json::parse(json, nullptr, false);
    if (!parsed.is_object() || parsed.value("version", nlohmann::json()) != version) {
        complaint = "the saved window settings cannot be read: the window starts with the defaults";
        return settings;
    }
    const std::optional<int> width = number(parsed, "width", least_side),
                             height = number(parsed, "height", least_side);
    if (width && height)
        settings.place = {*width, *height, {}, false};
    const std::optional<int> x = number(parsed, "x", -most_side), y = number(parsed, "y", -most_side);
    if (x && y)
        settings.place.corner = {*x, *y};
    read_flag(parsed, "maximised", settings.place.maximised);
    read_flag(parsed, "panel", settings.panel);
    return settings;
}

std::string write_settings(const WindowSettings& settings)
{
    nlohmann::ordered_json json = {
        {"version", version}, {"width", settings.place.width}, {"height", settings.place.height}};
    if (settings.place.corner) {
        json["x"] = settings.place.corner->x;
        json["y"] = settings.place.corner->y;
    }
    json["maximised"] = settings.place.maximised;
    json["panel"] = settings.panel;
    return text(json.dump(2), "\n");
}

WindowSettings load_settings(std::string& complaint)
{
    const std::optional<std::filesystem::path> file = settings_file();
    std::error_code ignored;
    if (!file || !std::filesystem::exists(*file, ignored))
        return {};
    try {
        const auto bytes = read_file(*file, most_bytes);
        WindowSettings settings = read_settings(std::string(bytes.begin(), bytes.end()), complaint);
        if (!complaint.empty())
            complaint = text(file->string(), ": ", complaint);
        return settings;
    } catch (const Error& error) {
        complaint = error.what();
        return {};
    }
}

void save_settings(const WindowSettings& settings)
{
    const std::optional<std::filesystem::path> file = settings_file();
    if (!file)
        return;
    try {
        std::filesystem::create_directories(file->parent_path());
        const std::string json = write_settings(settings);
        write_file(*file, {reinterpret_cast<const std::uint8_t*>(json.data()), json.size()});
    } catch (const std::exception&) {
    }
}

} // namespace lambent::view_window
