#include "apps/viewer/draw_scheduler.h"

#include "apps/common/layer_files.h"
#include "apps/common/picture_file.h"
#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace lambent::viewer {
namespace {

using Task = Plan::Task;

// Thrown out of a drawing that nobody wants any more.
struct Overtaken {};

// Whoever got a picture of something that moves this long ago still moves.
constexpr std::chrono::milliseconds lull{300};

// Others' time for each of a long picture's, while they move.
constexpr int others_share = 3;

double ms_since(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

bool is_transparent(const Plan& plan)
{
    return plan.arguments.settings.background.kind == draw::Background::Kind::none;
}

// The phong model has other layers than ggx, which the table names.
std::string layer_name(const Plan& plan)
{
    if (plan.arguments.settings.model != draw::Model::phong)
        return plan.layer;
    if (plan.layer == "base_color")
        return "diffuse";
    return plan.layer == "alpha" ? "exponent" : plan.layer;
}

// Null where the picture itself is asked for, or a layer that its model does not have.
const draw::Layer* layer_of(const Plan& plan, const draw::Frame& frame)
{
    const auto found = std::find_if(frame.layers.begin(), frame.layers.end(),
                                    [&](const draw::Layer& layer) { return layer.name == layer_name(plan); });
    return plan.layer == "picture" || found == frame.layers.end() ? nullptr : &*found;
}

image::CodeImage codes_of(const Plan& plan, const draw::Frame& frame)
{
    if (const draw::Layer* const layer = layer_of(plan, frame))
        return cli::layer_picture(*layer, plan.arguments.display);
    return cli::picture_codes(frame.radiance, plan.arguments.display, is_transparent(plan));
}

// What is the same for all pictures.
void complete(const Plan& plan, double draw_ms, ShownPicture& picture)
{
    picture.width = plan.width;
    picture.height = plan.height;
    picture.scale = plan.scale;
    picture.draw_ms = draw_ms;
    picture.input = plan.input;
    picture.moment = plan.moment;
}

ShownPicture picture_of(const Plan& plan, const draw::Frame& frame, double draw_ms)
{
    ShownPicture picture;
    picture.kind = plan.task == Task::moving  ? ShownPicture::Kind::moving
                   : plan.task == Task::still ? ShownPicture::Kind::still
                                              : ShownPicture::Kind::rest;
    picture.codes = codes_of(plan, frame);
    picture.is_last = plan.task == Task::rest && !plan.is_compared;
    complete(plan, draw_ms, picture);
    return picture;
}

void pick(const Plan& plan, const draw::Frame& frame, Session& session)
{
    const auto depth = std::find_if(frame.layers.begin(), frame.layers.end(),
                                    [](const draw::Layer& layer) { return layer.name == "depth"; });
    if (depth == frame.layers.end())
        return;
    const image::RadianceImage& image = depth->image;
    const auto at = [](double part, int side) {
        return std::clamp(static_cast<int>(part * side), 0, side - 1);
    };
    const int x = at(plan.place[0], image.width), y = at(plan.place[1], image.height);
    const float* pixel = image.pixel(x, y);
    if (!(pixel[3] > 0.0f))
        return; // the background: nothing to look at
    const draw::RayMap rays = draw::ray_map(plan.arguments.settings.camera, image.width, image.height);
    const glm::vec3 direction =
        glm::normalize(rays.direction + (static_cast<float>(x) + 0.5f) * rays.direction_dx +
                       (static_cast<float>(y) + 0.5f) * rays.direction_dy);
    session.picked(glm::dvec3(rays.origin + pixel[0] / pixel[3] * direction), plan);
}

void show(const Plan& plan, const draw::Frame& frame, double draw_ms, Session& session)
{
    if (plan.task == Task::pick) {
        pick(plan, frame, session);
    } else if (plan.task == Task::save) {
        const display::Settings& display = plan.arguments.display;
        session.presenter().save(
            {plan.file, cli::picture_bytes(frame.radiance, display, is_transparent(plan), plan.file),
             plan.command});
    } else {
        session.presenter().show(picture_of(plan, frame, draw_ms));
    }
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

// `is_moving`, which must not wait, of any other place; of this one, too, while it saves a picture, which need not be that
// of what moves.
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
        const bool may_be_long = now >= place.long_from || !any_moves(place, [&](const Place& other) {
                                     return other.session->is_hungry() || now - other.moved < lull;
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
           !any_moves(place, [](const Place& other) { return other.session->is_hungry(); });
}

// The plan's picture, in the plan's pose.
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
        place.session->paused(plan);
    }
}

// Shows what was drawn; the milliseconds are those of the drawing.
void DrawScheduler::finish(const Plan& plan, Session& session, draw::Frame frame, double milliseconds) const
{
    const Clock::time_point start = Clock::now();
    show(plan, frame, milliseconds, session);
    if (plan.task == Task::rest && plan.layer != "picture" && !layer_of(plan, frame))
        session.complain(text("the model phong has no layer ", plan.layer, ": this is the picture"));
    if (plan.is_compared)
        session.drawn(plan, std::move(frame.radiance));
    session.done(plan, milliseconds + ms_since(start));
}

// As long as there is something new to be seen by: a picture takes its time to be made and to be sent.
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
        place.session->paused(plan);
        return;
    }
    ShownPicture picture = plan.trace->picture();
    complete(plan, place.unseen_ms, picture);
    place.unseen_ms = 0.0;
    place.session->presenter().show(std::move(picture));
    if (finished)
        place.session->traced(plan);
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
        session.failed(plan, "");
    } catch (const std::bad_alloc&) {
        session.failed(plan, "not enough memory for the picture");
    } catch (const std::exception& error) {
        session.failed(plan, one_line(error.what()));
    }
    const Clock::time_point end = Clock::now();
    if (plan.is_long())
        place.long_from = end + others_share * (end - start);
    else
        place.moved = end;
}

} // namespace lambent::viewer
