#include "apps/view/memory.h"

#include "base/text.h"

#include <nlohmann/json.hpp>

#include <cstdlib>

namespace lambent::view_window {
namespace {

constexpr int version = 1, least_side = 320, most_side = 16384;

std::optional<int> side(const nlohmann::json& json, const char* name)
{
    const auto found = json.find(name);
    if (found == json.end() || !found->is_number_integer())
        return std::nullopt;
    const auto value = found->get<std::int64_t>();
    return value >= least_side && value <= most_side ? std::optional(static_cast<int>(value)) : std::nullopt;
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
    const std::optional<int> width = side(parsed, "width"), height = side(parsed, "height");
    if (width && height)
        memory.place = {*width, *height};
    if (const auto panel = parsed.find("panel"); panel != parsed.end() && panel->is_boolean())
        memory.panel = panel->get<bool>();
    return memory;
}

std::string write_memory(const Memory& memory)
{
    const nlohmann::ordered_json json = {{"version", version},
                                         {"width", memory.place.width},
                                         {"height", memory.place.height},
                                         {"panel", memory.panel}};
    return text(json.dump(2), "\n");
}

} // namespace lambent::view_window
