// The messages between server and browser, as text.
#pragma once

#include "apps/viewer/file_list.h"
#include "apps/viewer/session.h"

#include <string>
#include <string_view>

namespace lambent::serve {

/// The kind of a message.
enum class MessageKind {
    input, ///< an input, which may change the picture
    seen,  ///< a frame was seen
};

/// Thrown for a message that the page never sends; the connection is then closed.
class Malformed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Carries out a message: a JSON object with "do" and its parameters, as listed in docs/VIEWER.md. Throws Malformed for
/// anything else, and Error(usage) for values that are refused.
MessageKind handle_message(std::string_view message, viewer::Session& session, const viewer::FileList& files);

/// The first message to a page: the parameters, and the names of scenes and environments that may be opened.
std::string hello(const viewer::FileList& files);

/// {"type": "error", "line": ...}: shown by the page.
std::string error_message(const std::string& line);

/// A picture with its header: the length of a JSON object in four bytes, little-endian, the object, the picture.
std::vector<std::uint8_t> frame_message(const std::string& header, std::span<const std::uint8_t> picture);

} // namespace lambent::serve
