// What browsers say and are told, as text.
#pragma once

#include "apps/viewer/file_list.h"
#include "apps/viewer/session.h"

#include <string>
#include <string_view>

namespace lambent::serve {

/// What a message was, beyond what it did to the session.
enum class Heard {
    input, ///< something to draw, perhaps
    seen,  ///< a frame was seen
};

/// A message that no page of ours would send: whoever sends it is not listened to any longer.
class Malformed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Does what a message says: a JSON object with "do" and what that needs; docs/VIEWER.md lists them. Throws Malformed for
/// what is no such object, Error(usage) for values that are refused.
Heard hear(std::string_view message, viewer::Session& session, const viewer::FileList& files);

/// What a page needs at first: the parameters and the names that may be opened.
std::string hello(const viewer::FileList& files);

/// {"type": "error", "line": ...}
std::string error_message(const std::string& line);

/// A frame: the length of a JSON object in four bytes, little end first, the object, the picture.
std::vector<std::uint8_t> frame_message(const std::string& header, std::span<const std::uint8_t> picture);

} // namespace lambent::serve
