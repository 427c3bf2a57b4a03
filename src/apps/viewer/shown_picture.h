// Pictures for a viewer, and the interface that takes them.
#pragma once

#include "audit/interval.h"
#include "image/image.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lambent::viewer {

struct ShownPicture {
    /// Reduced, while the view moves; whole with few samples; as the command draws it; the reference or the difference
    /// to it.
    enum class Kind { moving, still, rest, traced };
    Kind kind = Kind::moving;
    image::CodeImage codes;
    int width = 0, height = 0; ///< as requested; `codes` may be smaller
    double scale = 1.0;        ///< of the width and height of `codes`
    double draw_ms = 0.0;
    std::uint64_t input = 0;           ///< the last input that was taken into account
    bool is_last = false;              ///< no better picture follows
    double moment = 0.0;               ///< time of the animation, seconds
    bool lacks_shadows = false;        ///< drawn without the bounces that were asked for, to hold the rate
    std::optional<audit::Error> error; ///< as measured; unset: not measured, or not yet

    /// Set for Kind::traced.
    struct Traced {
        double samples = 0.0; ///< per pixel
        /// Estimated relative RMSE of the pixels that show surfaces, exposed and clamped to 1; unset until it is known.
        std::optional<double> noise;
        /// Relative RMSE of the drawn picture, both exposed and clamped to 1; contains the noise.
        double error = 0.0;
        /// Mean FLIP of the drawn picture as displayed; set where the FLIP map is shown.
        std::optional<double> flip;
    };
    std::optional<Traced> traced;
};

/// "moving", "still", "rest" or "traced".
constexpr const char* name_of(ShownPicture::Kind kind)
{
    constexpr const char* names[] = {"moving", "still", "rest", "traced"};
    return names[static_cast<int>(kind)];
}

/// A picture encoded as a file.
struct Saved {
    std::string name; ///< "picture.png" or "picture.jpg"
    std::vector<std::uint8_t> bytes;
    std::string command; ///< that writes the same bytes
};

/// Takes the output of a session. The drawing thread makes all calls, and waits until they return.
class Presenter {
public:
    virtual ~Presenter() = default;

    /// At most Session::most_in_flight pictures are shown before Session::seen() is called.
    virtual void show(ShownPicture picture) = 0;

    /// Takes Session::state() after it changed.
    virtual void say(const std::string& state) = 0;

    virtual void save(Saved saved) = 0;
};

} // namespace lambent::viewer
