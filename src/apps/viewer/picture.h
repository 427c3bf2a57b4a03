// What a viewer is shown.
#pragma once

#include "image/image.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lambent::viewer {

struct Picture {
    /// While something moves; whole but with fewer samples; what the command draws.
    enum class Kind { moving, still, rest };
    Kind kind = Kind::moving;
    image::CodeImage codes;
    int width = 0, height = 0; ///< as wished; `codes` may be smaller
    double scale = 1.0;        ///< of `codes`' sides
    double draw_ms = 0.0;
    std::uint64_t input = 0; ///< the last input that it shows
};

/// A picture as a file.
struct Saved {
    std::string name; ///< picture.png
    std::vector<std::uint8_t> bytes;
    std::string command; ///< that writes the same bytes
};

/// Takes what a session shows: all calls come from the drawing thread, which waits meanwhile.
class Presenter {
public:
    virtual ~Presenter() = default;

    /// At most Session::most_in_flight are shown before the session is told that one was seen.
    virtual void show(Picture picture) = 0;

    /// What is set, as Session::state, after it changed.
    virtual void say(const std::string& state) = 0;

    virtual void save(Saved saved) = 0;
};

} // namespace lambent::viewer
