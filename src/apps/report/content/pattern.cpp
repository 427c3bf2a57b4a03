#include "apps/report/content/pattern.h"

#include "base/text.h"

#include <stdexcept>

namespace lambent::report {
namespace {

// Calls plain(text) and name(placeholder) for the parts of a pattern, in order.
template <class Plain, class Name>
void for_each_part(std::string_view pattern, Plain&& plain, Name&& name)
{
    std::size_t at = 0;
    while (at < pattern.size()) {
        const std::size_t open = pattern.find_first_of("{}", at);
        plain(pattern.substr(at, open - at));
        if (open == std::string_view::npos)
            return;
        const std::size_t close = pattern.find_first_of("{}", open + 1);
        if (pattern[open] != '{' || close == std::string_view::npos || pattern[close] != '}')
            throw std::logic_error(text("unpaired brace in \"", pattern, "\""));
        name(pattern.substr(open + 1, close - open - 1));
        at = close + 1;
    }
}

} // namespace

std::vector<std::string> placeholders(std::string_view pattern)
{
    std::vector<std::string> names;
    for_each_part(
        pattern, [](std::string_view) {}, [&](std::string_view name) { names.emplace_back(name); });
    return names;
}

std::string fill(std::string_view pattern, const Values& values)
{
    std::string filled;
    for_each_part(
        pattern, [&](std::string_view plain) { filled += plain; },
        [&](std::string_view name) {
            const auto found = values.find(std::string(name));
            if (found == values.end())
                throw std::logic_error(text("no value for {", name, "} in \"", pattern, "\""));
            filled += found->second;
        });
    return filled;
}

} // namespace lambent::report
