// Recognizes image formats by a file's first bytes.
#pragma once

#include "image/byte_source.h"

#include <cstdint>
#include <span>

namespace lambent::image {

enum class Content { radiance, exr, png, jpeg, other };

Content content_of(std::span<const std::uint8_t> bytes);

/// Reads the first bytes of `source`. Throws Error(bad_input) if it is empty.
Content content_of(ByteSource& source);

/// The format's name with its article, for messages: "a PNG".
const char* name_of(Content content);

} // namespace lambent::image
