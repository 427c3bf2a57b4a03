// Draws for all sessions, one picture at a time, each session in its turn.
#pragma once

#include "apps/viewer/session.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace lambent::viewer {

/// One thread, which uses all others of TBB. A picture of something at rest ends early when its session moves, or, after
/// a while that doubles each time, when another one does.
class Desk {
public:
    explicit Desk(Stock& stock);
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;
    ~Desk();

    void add(std::shared_ptr<Session> session);

    /// Closes it. What is being drawn for it ends soon.
    void remove(const std::shared_ptr<Session>& session);

    /// Ends the drawing for good; returns when nothing is shown any more.
    void stop();

    /// Something changed: there may be work. Any thread.
    void nudge();

    /// How long others wait at first for a picture at rest.
    static constexpr std::chrono::milliseconds first_slice{500};

private:
    struct Place {
        std::shared_ptr<Session> session;
        std::chrono::milliseconds slice = first_slice;
    };

    void work();
    void carry_out(const Plan& plan, Session& session, std::chrono::milliseconds slice);
    void draw(const Plan& plan, Session& session, std::chrono::milliseconds slice);
    void trace(const Plan& plan, Session& session);
    bool others_wait(const Session& session);
    void set_slice(const Session& session, bool overtaken);

    Stock& stock_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<Place> places_;
    std::size_t next_ = 0;
    bool nudged_ = false;
    std::atomic<bool> ending_ = false;
    std::thread thread_; ///< last: it uses the others
};

} // namespace lambent::viewer
