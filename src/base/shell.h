// Quotes words for a shell.
#pragma once

#include <string>

namespace lambent {

/// The word in a form that a POSIX shell reads back unchanged: in single quotes if it has any special character.
std::string shell_quoted(const std::string& word);

} // namespace lambent
