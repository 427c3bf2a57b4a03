// Files that are dropped onto a window by another program.
#pragma once

#include <string>
#include <vector>

namespace lambent::testing {

/// Drops files, by their absolute paths, onto the window of this title, as a file manager does [XDND 5], and waits until
/// they are taken. Why they were not; empty: they were.
std::string drop(const std::string& display, const std::string& title, const std::vector<std::string>& files);

} // namespace lambent::testing
