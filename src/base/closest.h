// What a mistyped word was probably meant to be.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lambent {

/// Letters to insert, leave out, replace, or exchange with their neighbour, that make one word the other: the optimal
/// string alignment distance. [Damerau 1964] O(a * b) time.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The one of `words` that the fewest edits make `word`, the first of several; empty if even that one is changed in over
/// two fifths of its letters, or in all but one.
std::string closest(std::string_view word, std::span<const std::string> words);

/// "; did you mean 'WORD'?", or nothing where nothing is close.
std::string did_you_mean(std::string_view word, std::span<const std::string> words);

} // namespace lambent
