#include "scene/gltf_document/gltf_losses.h"

#include "base/text.h"

namespace lambent::scene {
namespace {

// Replaces each number by '#': "node 12" and "node 7" are the same kind of line.
std::string without_numbers(const std::string& line)
{
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    std::string kind;
    for (const char c : line)
        if (!is_digit(c))
            kind += c;
        else if (kind.empty() || kind.back() != '#')
            kind += '#';
    return kind;
}

} // namespace

void Losses::add(std::string_view fault, std::string_view cost)
{
    if (fault.empty())
        return;
    std::string line = text(fault, cost.empty() ? "" : ": ", cost);
    const std::string kind = without_numbers(line);
    if (const auto known = lines_.find(kind); known != lines_.end()) {
        Line& same = known->second;
        ++same.more;
        warnings_[same.place] = text(same.first, " (and ", same.more, " more like it)");
    } else if (lines_.size() < most_lines) {
        lines_.emplace(kind, Line{warnings_.size(), line, 0});
        warnings_.push_back(std::move(line));
    } else {
        if (others_.more++ == 0) {
            others_.place = warnings_.size();
            warnings_.emplace_back();
        }
        warnings_[others_.place] = text(file_, ": and ", others_.more, " more faults");
    }
}

Error told_already()
{
    return {Failure::bad_input, ""};
}

} // namespace lambent::scene
