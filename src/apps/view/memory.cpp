#include "apps/view/memory.h"

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

std::optional<std::filesystem::path> memory_file()
{
    const std::filesystem::path name = "lambent/view.json";
    if (const char* folder = std::getenv("XDG_CONFIG_HOME"); folder && folder[0] == '/')
        return folder / name;
    if (const char* home = std::getenv("HOME"); home && home[0] == '/')
        return std::filesystem::path(home) / ".config" / name;
    return std::nullopt;
}

Memory read_memory(const std::string& json, std::string& complaint)
{
    Memory memory;
    const nlohmann::json parsed = nlohmann::json::parse(json, nullptr, false);
    if (!parsed.is_object() || parsed.value("version", nlohmann::json()) != version) {
        complaint = "what the window remembered cannot be read: it starts as usual";
        return memory;
    }
    const std::optional<int> width = number(parsed, "width", least_side),
                             height = number(parsed, "height", least_side);
    if (width && height)
        memory.place = {*width, *height, {}, false};
    const std::optional<int> x = number(parsed, "x", -most_side), y = number(parsed, "y", -most_side);
    if (x && y)
        memory.place.corner = {*x, *y};
    read_flag(parsed, "maximised", memory.place.maximised);
    read_flag(parsed, "panel", memory.panel);
    return memory;
}

std::string write_memory(const Memory& memory)
{
    nlohmann::ordered_json json = {
        {"version", version}, {"width", memory.place.width}, {"height", memory.place.height}};
    if (memory.place.corner) {
        json["x"] = memory.place.corner->x;
        json["y"] = memory.place.corner->y;
    }
    json["maximised"] = memory.place.maximised;
    json["panel"] = memory.panel;
    return text(json.dump(2), "\n");
}

Memory load_memory(std::string& complaint)
{
    const std::optional<std::filesystem::path> file = memory_file();
    std::error_code ignored;
    if (!file || !std::filesystem::exists(*file, ignored))
        return {};
    try {
        const auto bytes = read_file(*file, most_bytes);
        Memory memory = read_memory(std::string(bytes.begin(), bytes.end()), complaint);
        if (!complaint.empty())
            complaint = text(file->string(), ": ", complaint);
        return memory;
    } catch (const Error& error) {
        complaint = error.what();
        return {};
    }
}

void keep_memory(const Memory& memory)
{
    const std::optional<std::filesystem::path> file = memory_file();
    if (!file)
        return;
    try {
        std::filesystem::create_directories(file->parent_path());
        const std::string json = write_memory(memory);
        write_file(*file, {reinterpret_cast<const std::uint8_t*>(json.data()), json.size()});
    } catch (const std::exception&) {
    }
}

} // namespace lambent::view_window
