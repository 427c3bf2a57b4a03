#include "base/closest.h"

#include "base/text.h"

#include <algorithm>
#include <vector>

namespace lambent {
namespace {

// Longer words are hardly typing errors, and the distance takes quadratic time.
constexpr std::size_t longest = 64;

} // namespace

std::size_t edit_distance(std::string_view a, std::string_view b)
{
    // Three rows of the table: the distances of every prefix of `b` from the prefixes of `a` that end two letters
    // before the current one (`before`), one letter before it (`last`) and with it (`now`).
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = std::min(now[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, now);
    }
    return last[b.size()];
}

std::string closest(std::string_view word, std::span<const std::string> words)
{
    std::string best;
    std::size_t least = word.size() + 1;
    if (word.size() > longest)
        return best;
    for (const std::string& candidate : words) {
        const std::size_t length = std::max(word.size(), candidate.size());
        const std::size_t edits = edit_distance(word, candidate);
        if (edits < least && 5 * edits <= 2 * length && edits + 1 < length) {
            least = edits;
            best = candidate;
        }
    }
    return best;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> words)
{
    const std::string best = closest(word, words);
    return best.empty() ? best : text("; did you mean '", best, "'?");
}

} // namespace lambent
