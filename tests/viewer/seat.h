// A viewer at a scheduler, who waits for what it is shown.
#pragma once

#include "apps/viewer/draw_scheduler.h"
#include "base/file.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <deque>

namespace lambent::viewer {

// Keeps what it is shown; waits for it.
class Audience : public Presenter {
public:
    void show(ShownPicture picture) override { keep(pictures, std::move(picture)); }
    void say(const std::string& state) override { keep(states, state); }
    void save(Saved file) override { keep(saved, std::move(file)); }

    template <class Condition>
    bool wait(Condition&& condition)
    {
        std::unique_lock lock(mutex);
        return changed.wait_for(lock, std::chrono::seconds(60 * testing::patience), condition);
    }

    std::mutex mutex;
    std::condition_variable changed;
    std::deque<ShownPicture> pictures;
    std::deque<std::string> states;
    std::deque<Saved> saved;

private:
    template <class T>
    void keep(std::deque<T>& list, T thing)
    {
        const std::lock_guard lock(mutex);
        list.push_back(std::move(thing));
        changed.notify_all();
    }
};

struct Seat {
    Seat(DrawScheduler& at, AssetCache& assets, ViewRequest request)
        : scheduler(at), audience(std::make_shared<Audience>()),
          session(std::make_shared<Session>(std::move(request), assets, audience))
    {
        scheduler.add(session);
    }
    Seat(const Seat&) = delete;
    Seat& operator=(const Seat&) = delete;
    ~Seat() { scheduler.remove(session); }

    // Sees every picture until there is one of `kind` that shows `input`.
    ShownPicture wait_for(ShownPicture::Kind kind, std::uint64_t input)
    {
        ShownPicture last;
        do {
            if (!audience->wait([&] { return !audience->pictures.empty(); })) {
                ADD_FAILURE() << "no picture";
                return last;
            }
            const std::lock_guard lock(audience->mutex);
            last = std::move(audience->pictures.front());
            audience->pictures.pop_front();
            session->seen();
            scheduler.nudge();
        } while (last.kind != kind || last.input < input);
        return last;
    }

    void change(std::uint64_t input, const Session::Change& change)
    {
        session->change(input, change);
        scheduler.nudge();
    }

    DrawScheduler& scheduler;
    std::shared_ptr<Audience> audience;
    std::shared_ptr<Session> session;
};

inline ViewRequest small_wish(const std::string& scene)
{
    ViewRequest request = default_request(scene, "furnace");
    set_size(request, 96, 64);
    set_value(request.asked, "samples", "8");
    return request;
}

// What a command writes that `lambent` starts with.
inline std::vector<std::uint8_t> rendered(const std::string& command, const testing::Folder& folder)
{
    const testing::Outcome outcome =
        testing::run_program("/bin/sh", {"-c", "cd '" + folder.path("") + "' && " +
                                                   std::string(LAMBENT_PROGRAM) + command.substr(7)});
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return read_file(folder.path(command.substr(command.rfind(' ') + 1)));
}

} // namespace lambent::viewer
