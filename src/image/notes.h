// Remarks about an image that its file carries beside the pixels.
#pragma once

#include <string>
#include <vector>

namespace lambent::image {

/// A key of 1 to 79 and a value of any number of printable ASCII characters.
struct Note {
    std::string key, value;
};

using Notes = std::vector<Note>;

} // namespace lambent::image
