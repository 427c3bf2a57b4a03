#include "apps/viewer/draw_scheduler.h"

#include "apps/viewer/present_frame.h"
#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <new>
#include <utility>

namespace lambent::viewer {
namespace {

using Task = Plan::Task;

// Thrown from a progress callback to leave a drawing that is no longer wanted.
struct Overtaken {};

// A session counts as moving for so long after its last picture of a moving view.
constexpr std::chrono::milliseconds lull{300};

// While other sessions move, a long picture waits three times as long as it was drawn: it gets a quarter of the time.
constexpr int others_share = 3;

double ms_since(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

} // namespace

DrawScheduler::DrawScheduler(AssetCache& assets) : assets_(assets), thread_([this] { work(); })
{
    assets_.on_change([this] { nudge(); });
}

DrawScheduler::~DrawScheduler()
{
    assets_.on_change({});
    stop();
}

void DrawScheduler::stop()
{
    ending_ = true;
    nudge();
    if (thread_.joinable())
        thread_.join();
}

void DrawScheduler::add(std::shared_ptr<Session> session)
{
    {
        const std::lock_guard lock(mutex_);
        places_.push_back(std::make_shared<Place>());
        places_.back()->session = std::move(session);
    }
    nudge();
}

void DrawScheduler::remove(const std::shared_ptr<Session>& session)
{
    session->close();
    const std::lock_guard lock(mutex_);
    std::erase_if(places_, [&](const std::shared_ptr<Place>& place) { return place->session == session; });
}

void DrawScheduler::nudge()
{
    {
        const std::lock_guard lock(mutex_);
        nudged_ = true;
    }
    wake_.notify_all();
}

DrawScheduler::Places DrawScheduler::places()
{
    const std::lock_guard lock(mutex_);
    return places_;
}

// Returns whether `is_moving`, which must not block, holds for another session; also for this one while it saves a
// picture, as its view may have moved on since.
template <class IsMoving>
bool DrawScheduler::any_moves(const Place& place, const IsMoving& is_moving)
{
    const std::lock_guard lock(mutex_);
    return std::any_of(places_.begin(), places_.end(), [&](const std::shared_ptr<Place>& other) {
        return (other.get() != &place || place.session->is_saving()) && is_moving(*other);
    });
}

void DrawScheduler::work()
{
    while (!ending_) {
        Clock::time_point wake = Clock::now() + std::chrono::seconds(10);
        if (work_once(wake))
            continue;
        std::unique_lock lock(mutex_);
        wake_.wait_until(lock, wake, [this] { return nudged_ || ending_; });
        nudged_ = false;
    }
}

bool DrawScheduler::work_once(Clock::time_point& wake)
{
    const Places all = places();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::size_t turn = (next_ + i) % all.size();
        Place& place = *all[turn];
        const Clock::time_point now = Clock::now();
        const bool may_be_long =
            now >= place.long_from || !any_moves(place, [&](const Place& other) {
                return other.session->waits_for_moving_picture() || now - other.moved < lull;
            });
        if (!may_be_long)
            wake = std::min({wake, place.long_from, now + lull});
        if (const std::optional<Plan> plan = place.session->plan(now, wake, may_be_long)) {
            next_ = turn + 1;
            carry_out(*plan, place);
            return true;
        }
    }
    return false;
}

bool DrawScheduler::goes_on(const Plan& plan, const Place& place, Clock::time_point start)
{
    if (ending_ || (plan.is_long() && place.session->is_stale(plan)))
        throw Overtaken{};
    return !plan.is_long() || Clock::now() - start < slice ||
           !any_moves(place, [](const Place& other) { return other.session->waits_for_moving_picture(); });
}

// Returns the plan's picture, paused or new, with the model in the plan's pose.
DrawScheduler::BegunPicture DrawScheduler::begin_or_go_on(const Plan& plan, Place& place)
{
    plan.model->pose(plan.arguments);
    if (place.paused && place.session->is_stale(place.paused->plan))
        place.paused.reset();
    if (place.paused && place.paused->plan.task == plan.task && place.paused->plan.serial == plan.serial)
        return std::move(place.paused);
    const auto& environment = plan.environment->environment;
    const draw::Settings& settings = plan.arguments.settings;
    draw::Renderer& renderer = plan.model->renderer(settings.texel_transfer);
    return std::make_unique<Begun>(
        Begun{plan, renderer.start(environment ? &*environment : nullptr, settings)});
}

void DrawScheduler::draw(const Plan& plan, Place& place)
{
    const Clock::time_point start = Clock::now();
    BegunPicture begun = begin_or_go_on(plan, place);
    const bool whole = begun->drawing->advance([&](float) { return goes_on(plan, place, start); });
    begun->milliseconds += ms_since(start);
    if (whole) {
        finish(plan, *place.session, begun->drawing->take(), begun->milliseconds);
    } else {
        place.paused = std::move(begun);
        place.session->plan_paused(plan);
    }
}

// Shows the frame; `milliseconds` is how long drawing took.
void DrawScheduler::finish(const Plan& plan, Session& session, draw::Frame frame, double milliseconds) const
{
    const Clock::time_point start = Clock::now();
    present_frame(plan, frame, milliseconds, session);
    if (plan.task == Task::rest && lacks_layer(plan, frame))
        session.report_error(text("the model phong has no layer ", plan.layer, ": this is the picture"));
    if (plan.is_compared)
        session.light_drawn(plan, std::move(frame.radiance));
    session.picture_finished(plan, milliseconds + ms_since(start));
}

// Shows a picture of the trace every 400 ms of tracing, as making and sending one takes time.
void DrawScheduler::trace(const Plan& plan, Place& place)
{
    constexpr double step_ms = 400.0;
    const Clock::time_point start = Clock::now();
    const bool finished = plan.trace->advance([&](const reference::Progress&) {
        const bool is_due = plan.trace->has_picture() && place.unseen_ms + ms_since(start) >= step_ms;
        return goes_on(plan, place, start) && !is_due;
    });
    place.unseen_ms += ms_since(start);
    if (!finished && (place.unseen_ms < step_ms || !plan.trace->has_picture())) {
        place.session->plan_paused(plan);
        return;
    }
    ShownPicture picture = plan.trace->picture();
    complete_picture(plan, place.unseen_ms, picture);
    place.unseen_ms = 0.0;
    place.session->presenter().show(std::move(picture));
    if (finished)
        place.session->trace_finished(plan);
}

void DrawScheduler::carry_out(const Plan& plan, Place& place)
{
    const Clock::time_point start = Clock::now();
    Session& session = *place.session;
    try {
        if (plan.task == Task::trace)
            trace(plan, place);
        else
            draw(plan, place);
    } catch (const Overtaken&) {
        session.plan_failed(plan, "");
    } catch (const std::bad_alloc&) {
        session.plan_failed(plan, "not enough memory for the picture");
    } catch (const std::exception& error) {
        session.plan_failed(plan, one_line(error.what()));
    }
    const Clock::time_point end = Clock::now();
    if (plan.is_long())
        place.long_from = end + others_share * (end - start);
    else
        place.moved = end;
}

} // namespace lambent::viewer
