// Finds the word that a mistyped word probably stands for.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lambent {

/// Fewest insertions, deletions, replacements and exchanges of neighbouring letters that turn one word into the other:
/// the optimal string alignment distance. [Damerau 1964] O(a * b) time.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word of `words` with the smallest edit distance from `word`, the first of several. Empty if that distance is
/// over two fifths of the longer word's length, or leaves less than two of its letters unchanged.
std::string closest(std::string_view word, std::span<const std::string> words);

/// "; did you mean 'WORD'?", or an empty string if no word is close.
std::string did_you_mean(std::string_view word, std::span<const std::string> words);

} // namespace lambent
