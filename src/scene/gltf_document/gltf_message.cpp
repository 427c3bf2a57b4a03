#include "scene/gltf_document/gltf_message.h"

#include <algorithm>

namespace lambent::scene {

std::string printable(std::string_view text)
{
    constexpr std::size_t longest = 200;
    std::string shown(text.substr(0, longest));
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; },
        '?');
    return text.size() > longest ? shown + "..." : shown;
}

} // namespace lambent::scene
