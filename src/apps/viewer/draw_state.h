// How far a session's picture has been drawn, and what the session waits for.
#pragma once

#include <cstdint>
#include <mutex>

namespace lambent::viewer {

/// The part of a session that drawing threads poll between tiles, also for other sessions. The session's own mutex is
/// held while assets are looked up and JSON is written; this class therefore has a mutex of its own. Each function
/// holds it for a few instructions only and calls nothing outside, so all may be called from any thread and under any
/// lock.
///
/// A request passes through these stages in order, some of them skipped, until request_view() replaces it:
///
///     requested -> moving -> still -> rest -> finished
class DrawState {
public:
    /// Numbers requests, from 1.
    using Serial = std::uint64_t;

    /// The best picture of the current request that was drawn.
    enum class Stage {
        requested, ///< none yet
        moving,    ///< the reduced one of a view that may move on
        still,     ///< the whole one with few samples
        rest,      ///< the one that the request's command writes
        finished,  ///< the traced reference, or drawing failed: the request is not drawn again
    };

    /// At most this many pictures are planned or shown but not yet seen.
    static constexpr int most_in_flight = 2;

    /// Another view is wanted: a new serial, at the stage `requested`.
    void request_view();

    /// Raises the stage of request `serial`; does nothing if that is no longer the current one.
    void picture_finished(Serial serial, Stage stage);

    /// Request `serial` cannot be drawn: if it is the current one, its stage becomes `finished`.
    void request_failed(Serial serial);

    /// A picture to be shown was planned: one more is in flight.
    void picture_started();

    /// The viewer saw a picture, or one was given up: one less is in flight, never below 0.
    void picture_left();

    /// Counts pictures to be saved; save_finished() also where saving failed.
    void save_requested();
    void save_finished();

    /// Whether there is a scene and an environment to draw with, of this request or of an earlier one.
    void set_drawable(bool drawable);

    /// Whether an animation with a duration above 0 is playing.
    void set_animated(bool animated);

    /// Nothing more is drawn. Final.
    void close();

    Serial serial() const;
    Stage stage() const;
    int unsaved() const;
    bool is_closed() const;
    bool is_current(Serial serial) const;
    bool can_show_more() const;

    /// Whether a picture of a moving view can be drawn and is waited for.
    bool waits_for_moving_picture() const;

private:
    struct Values {
        Serial serial = 1;
        Stage stage = Stage::requested;
        int in_flight = 0, unsaved = 0;
        bool drawable = false, animated = false, closed = false;
    };

    mutable std::mutex mutex_;
    Values values_;
};

} // namespace lambent::viewer
