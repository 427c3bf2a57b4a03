#include "scene/gltf_document/document_position.h"

#include "base/text.h"

#include <algorithm>
#include <array>

namespace lambent::scene {
namespace {

std::string describe(const DocumentPosition& position)
{
    std::string words = position.outer ? describe(*position.outer) : std::string();
    if (position.name.empty())
        return words;
    if (!words.empty())
        words += ", ";
    words += position.name;
    return position.index < 0 ? words : text(words, " ", position.index);
}

} // namespace

std::string fault_at(const DocumentPosition& position, const std::string& reason)
{
    const std::string words = describe(position);
    return text(words, words.empty() ? "" : ": ", reason);
}

bool holds_geometry(const DocumentPosition& position)
{
    constexpr std::array<std::string_view, 7> lists = {"",         "scene",      "node",  "mesh",
                                                       "accessor", "bufferView", "buffer"};
    const DocumentPosition* outermost = &position;
    while (outermost->outer != nullptr && !outermost->outer->name.empty())
        outermost = outermost->outer;
    return std::find(lists.begin(), lists.end(), outermost->name) != lists.end();
}

} // namespace lambent::scene
