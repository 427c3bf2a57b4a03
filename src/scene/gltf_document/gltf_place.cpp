#include "scene/gltf_document/gltf_place.h"

#include "base/text.h"

#include <algorithm>
#include <array>

namespace lambent::scene {
namespace {

std::string describe(const Place& place)
{
    std::string words = place.outer ? describe(*place.outer) : std::string();
    if (place.name.empty())
        return words;
    if (!words.empty())
        words += ", ";
    words += place.name;
    return place.index < 0 ? words : text(words, " ", place.index);
}

} // namespace

std::string fault_at(const Place& place, const std::string& reason)
{
    const std::string words = describe(place);
    return text(words, words.empty() ? "" : ": ", reason);
}

bool holds_geometry(const Place& place)
{
    constexpr std::array<std::string_view, 7> lists = {"",         "scene",      "node",  "mesh",
                                                       "accessor", "bufferView", "buffer"};
    const Place* outermost = &place;
    while (outermost->outer != nullptr && !outermost->outer->name.empty())
        outermost = outermost->outer;
    return std::find(lists.begin(), lists.end(), outermost->name) != lists.end();
}

} // namespace lambent::scene
