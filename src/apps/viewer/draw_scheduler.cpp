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
struct Abandoned {};

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
        clients_.push_back(std::make_shared<Client>());
        clients_.back()->session = std::move(session);
    }
    nudge();
}

void DrawScheduler::remove(const std::shared_ptr<Session>& session)
{
    session->close();
    const std::lock_guard lock(mutex_);
    std::erase_if(clients_,
                  [&](const std::shared_ptr<Client>& client) { return client->session == session; });
}

void DrawScheduler::nudge()
{
    {
        const std::lock_guard lock(mutex_);
        nudged_ = true;
    }
    wake_.notify_all();
}

DrawScheduler::Clients DrawScheduler::clients()
{
    const std::lock_guard lock(mutex_);
    return clients_;
}

// Returns whether `is_moving`, which must not block, holds for another session; also for this one while it saves a
// picture, as its view may have moved on since.
template <class IsMoving>
bool DrawScheduler::any_other(const Client& client, const IsMoving& is_moving)
{
    const std::lock_guard lock(mutex_);
    return std::any_of(clients_.begin(), clients_.end(), [&](const std::shared_ptr<Client>& other) {
        return (other.get() != &client || client.session->is_saving()) && is_moving(*other);
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
    const Clients all = clients();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::size_t turn = (next_ + i) % all.size();
        Client& client = *all[turn];
        const Clock::time_point now = Clock::now();
        const bool may_be_long =
            now >= client.long_after || !any_other(client, [&](const Client& other) {
                return other.session->waits_for_moving_picture() || now - other.moved < lull;
            });
        if (!may_be_long)
            wake = std::min({wake, client.long_after, now + lull});
        if (const std::optional<Plan> plan = client.session->plan(now, wake, may_be_long)) {
            next_ = turn + 1;
            carry_out(*plan, client);
            return true;
        }
    }
    return false;
}

bool DrawScheduler::may_continue(const Plan& plan, const Client& client, Clock::time_point start)
{
    if (ending_ || (plan.is_long() && client.session->is_stale(plan)))
        throw Abandoned{};
    return !plan.is_long() || Clock::now() - start < slice ||
           !any_other(client, [](const Client& other) { return other.session->waits_for_moving_picture(); });
}

// Returns the plan's picture, paused or new, with the model in the plan's pose.
DrawScheduler::BegunPicture DrawScheduler::begin_or_resume(const Plan& plan, Client& client)
{
    plan.model->pose(plan.arguments);
    if (client.paused && client.session->is_stale(client.paused->plan))
        client.paused.reset();
    if (client.refinement && client.refinement->serial() != plan.serial && plan.task != Task::save)
        client.refinement.reset();
    if (client.paused && client.paused->plan.task == plan.task && client.paused->plan.serial == plan.serial)
        return std::move(client.paused);
    const auto& environment = plan.environment->environment;
    const draw::Settings& settings = plan.arguments.settings;
    draw::Renderer& renderer = plan.model->renderer(settings);
    return std::make_unique<Begun>(
        Begun{plan, renderer.start(environment ? &*environment : nullptr, settings)});
}

void DrawScheduler::draw(const Plan& plan, Client& client)
{
    const Clock::time_point start = Clock::now();
    if (plan.task == Task::save && save_refined(plan, client))
        return;
    BegunPicture begun = begin_or_resume(plan, client);
    const bool whole = begun->drawing->advance([&](float) { return may_continue(plan, client, start); });
    begun->milliseconds += ms_since(start);
    if (!whole) {
        client.paused = std::move(begun);
        client.session->plan_paused(plan);
    } else if (plan.task == Task::save) {
        save(plan, client, begun->drawing->take());
    } else if (plan.is_refined) {
        client.refinement = std::make_unique<Refinement>(plan, std::move(begun->drawing),
                                                         [&] { may_continue(plan, client, start); });
        finish(plan, *client.session, client.refinement->frame(), begun->milliseconds);
    } else {
        finish(plan, *client.session, begun->drawing->take(), begun->milliseconds);
    }
}

// Hands the frame over with the error that the command would write with it.
void DrawScheduler::save(const Plan& plan, Client& client, draw::Frame frame)
{
    const Clock::time_point start = Clock::now();
    Plan measured = plan;
    measured.error = error_in_file(plan, frame.radiance, [&] { may_continue(plan, client, start); });
    finish(measured, *client.session, std::move(frame), 0.0);
}

// Saves the picture that is being refined, if it is the one that is asked for, without drawing it again.
bool DrawScheduler::save_refined(const Plan& plan, Client& client)
{
    const Refinement* const known = client.refinement.get();
    if (!known || known->serial() != plan.serial || known->passes() != plan.arguments.settings.passes)
        return false;
    if (!known->is_measured()) {
        plan.model->pose(plan.arguments);
        save(plan, client, known->frame());
        return true;
    }
    Plan measured = plan;
    measured.error = known->error();
    finish(measured, *client.session, known->frame(), 0.0);
    return true;
}

// Shows the picture again after each measurement, and with more rays.
void DrawScheduler::refine(const Plan& plan, Client& client)
{
    const Clock::time_point start = Clock::now();
    Session& session = *client.session;
    if (!client.refinement || client.refinement->serial() != plan.serial) {
        session.plan_paused(plan);
        session.refinement_finished(plan);
        return;
    }
    Refinement& refinement = *client.refinement;
    plan.model->pose(plan.arguments);
    const bool done = refinement.advance([&] { return may_continue(plan, client, start); });
    client.unseen_ms += ms_since(start);
    if (!done) {
        session.plan_paused(plan);
        return;
    }
    Plan shown = plan;
    shown.error = refinement.error();
    shown.is_refined = !refinement.is_finished();
    session.refined(plan, refinement.passes());
    present_frame(shown, refinement.frame(), std::exchange(client.unseen_ms, 0.0), session);
    if (refinement.is_finished())
        session.refinement_finished(plan);
}

// Shows the frame; `milliseconds` is how long drawing took.
void DrawScheduler::finish(const Plan& plan, Session& session, draw::Frame frame, double milliseconds) const
{
    const Clock::time_point start = Clock::now();
    present_frame(plan, frame, milliseconds, session);
    if (plan.task == Task::rest && lacks_layer(plan, frame))
        session.report_error(
            text("the model phong has no layer ", plan.layer, ": the picture is shown instead"));
    if (plan.is_compared)
        session.light_drawn(plan, std::move(frame.radiance));
    session.picture_finished(plan, milliseconds + ms_since(start));
}

// Shows a picture of the trace every 400 ms of tracing, as making and sending one takes time.
void DrawScheduler::trace(const Plan& plan, Client& client)
{
    constexpr double step_ms = 400.0;
    const Clock::time_point start = Clock::now();
    const bool finished = plan.trace->advance([&](const reference::Progress&) {
        const bool is_due = plan.trace->has_picture() && client.unseen_ms + ms_since(start) >= step_ms;
        return may_continue(plan, client, start) && !is_due;
    });
    client.unseen_ms += ms_since(start);
    if (!finished && (client.unseen_ms < step_ms || !plan.trace->has_picture())) {
        client.session->plan_paused(plan);
        return;
    }
    ShownPicture picture = plan.trace->picture();
    complete_picture(plan, client.unseen_ms, picture);
    client.unseen_ms = 0.0;
    client.session->presenter().show(std::move(picture));
    if (finished)
        client.session->trace_finished(plan);
}

void DrawScheduler::carry_out(const Plan& plan, Client& client)
{
    const Clock::time_point start = Clock::now();
    Session& session = *client.session;
    try {
        if (plan.task == Task::trace)
            trace(plan, client);
        else if (plan.task == Task::refine)
            refine(plan, client);
        else
            draw(plan, client);
    } catch (const Abandoned&) {
        session.plan_failed(plan, "");
    } catch (const std::bad_alloc&) {
        session.plan_failed(plan, "not enough memory for the picture");
    } catch (const std::exception& error) {
        session.plan_failed(plan, one_line(error.what()));
    }
    const Clock::time_point end = Clock::now();
    if (plan.is_long())
        client.long_after = end + others_share * (end - start);
    else
        client.moved = end;
}

} // namespace lambent::viewer
