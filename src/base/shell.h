// Words for a shell.
#pragma once

#include <string>

namespace lambent {

/// A word as a POSIX shell reads it back: in single quotes unless all of it is plain.
std::string shell_quoted(const std::string& word);

} // namespace lambent
