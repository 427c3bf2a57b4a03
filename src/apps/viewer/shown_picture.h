// What a viewer is shown.
#pragma once

#include "image/image.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lambent::viewer {

struct ShownPicture {
    /// While something moves; whole but with fewer samples; what the command draws; the reference, or the difference to it.
    enum class Kind { moving, still, rest, traced };
    Kind kind = Kind::moving;
    image::CodeImage codes;
    int width = 0, height = 0; ///< as wished; `codes` may be smaller
    double scale = 1.0;        ///< of `codes`' sides
    double draw_ms = 0.0;
    std::uint64_t input = 0; ///< the last input that it shows
    bool is_last = false;    ///< nothing better follows
    double moment = 0.0;     ///< of the animation, seconds

    /// Of Kind::traced.
    struct Traced {
        double samples = 0.0; ///< per pixel
        std::optional<double>
            noise; ///< relative RMSE that is expected where surfaces are, light cut at 1 after exposure, once known
        double error = 0.0; ///< relative RMSE of the drawn picture, both exposed and cut at 1; noise included
        std::optional<double> flip; ///< mean FLIP of the drawn picture as displayed, where that is shown
    };
    std::optional<Traced> traced;
};

/// "moving", "still", "rest" or "traced".
constexpr const char* name_of(ShownPicture::Kind kind)
{
    constexpr const char* names[] = {"moving", "still", "rest", "traced"};
    return names[static_cast<int>(kind)];
}

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
    virtual void show(ShownPicture picture) = 0;

    /// What is set, as Session::state, after it changed.
    virtual void say(const std::string& state) = 0;

    virtual void save(Saved saved) = 0;
};

} // namespace lambent::viewer
