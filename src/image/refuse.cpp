#include "image/refuse.h"

namespace lambent::image {

void check_size(const std::string& name, std::int64_t width, std::int64_t height)
{
    if (width <= 0 || height <= 0)
        refuse(name, "the size ", width, "x", height, " is not positive");
    if (width > max_side || height > max_side || width * height > max_pixels)
        refuse(name, "the size ", width, "x", height, " is above the limit of ", max_side, " a side and ",
               max_pixels, " pixels");
}

std::string printable(std::string_view bytes, std::size_t longest)
{
    std::string line(bytes.substr(0, longest));
    for (char& c : line)
        if (c < ' ' || c > '~')
            c = '?';
    return bytes.size() > longest ? line + "..." : line;
}

} // namespace lambent::image
