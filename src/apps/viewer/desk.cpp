#include "apps/viewer/desk.h"

#include "apps/cli/layer_files.h"
#include "apps/cli/picture_file.h"
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
struct Overtaken {
    bool by_others;
};

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
void complete(const Plan& plan, double draw_ms, Picture& picture)
{
    picture.width = plan.width;
    picture.height = plan.height;
    picture.scale = plan.scale;
    picture.draw_ms = draw_ms;
    picture.input = plan.input;
    picture.moment = plan.moment;
}

Picture picture_of(const Plan& plan, const draw::Frame& frame, double draw_ms)
{
    Picture picture;
    picture.kind = plan.task == Task::moving  ? Picture::Kind::moving
                   : plan.task == Task::still ? Picture::Kind::still
                                              : Picture::Kind::rest;
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

Desk::Desk(Stock& stock) : stock_(stock), thread_([this] { work(); })
{
    stock_.on_change([this] { nudge(); });
}

Desk::~Desk()
{
    stock_.on_change({});
    stop();
}

void Desk::stop()
{
    ending_ = true;
    nudge();
    if (thread_.joinable())
        thread_.join();
}

void Desk::add(std::shared_ptr<Session> session)
{
    {
        const std::lock_guard lock(mutex_);
        places_.push_back({std::move(session)});
    }
    nudge();
}

void Desk::remove(const std::shared_ptr<Session>& session)
{
    session->close();
    const std::lock_guard lock(mutex_);
    std::erase_if(places_, [&](const Place& place) { return place.session == session; });
}

void Desk::nudge()
{
    {
        const std::lock_guard lock(mutex_);
        nudged_ = true;
    }
    wake_.notify_all();
}

bool Desk::others_wait(const Session& session)
{
    const std::lock_guard lock(mutex_);
    return std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
        return place.session.get() != &session && place.session->is_hungry();
    });
}

void Desk::set_slice(const Session& session, bool overtaken)
{
    const std::lock_guard lock(mutex_);
    for (Place& place : places_)
        if (place.session.get() == &session)
            place.slice = overtaken ? 2 * place.slice : first_slice;
}

void Desk::work()
{
    while (!ending_) {
        std::vector<Place> places;
        {
            const std::lock_guard lock(mutex_);
            nudged_ = false;
            places = places_;
        }
        Clock::time_point wake = Clock::now() + std::chrono::seconds(10);
        bool worked = false;
        for (std::size_t i = 0; i < places.size() && !worked; ++i) {
            const std::size_t turn = (next_ + i) % places.size();
            if (const std::optional<Plan> plan = places[turn].session->plan(Clock::now(), wake)) {
                next_ = turn + 1;
                carry_out(*plan, *places[turn].session, places[turn].slice);
                worked = true;
            }
        }
        std::unique_lock lock(mutex_);
        if (!worked)
            wake_.wait_until(lock, wake, [this] { return nudged_ || ending_; });
    }
}

void Desk::draw(const Plan& plan, Session& session, std::chrono::milliseconds slice)
{
    const Clock::time_point start = Clock::now();
    const bool may_be_left = plan.task == Task::still || plan.task == Task::rest;
    const auto check = [&](float) {
        if (ending_ || (may_be_left && session.is_stale(plan)))
            throw Overtaken{false};
        if (may_be_left && Clock::now() - start > slice && others_wait(session))
            throw Overtaken{true};
    };
    const auto& environment = plan.environment->environment;
    const draw::Settings& settings = plan.arguments.settings;
    plan.model->pose(plan.arguments);
    draw::Renderer& renderer = plan.model->renderer(settings.texel_transfer);
    draw::Frame frame = renderer.draw(environment ? &*environment : nullptr, settings, check);
    show(plan, frame, ms_since(start), session);
    if (plan.task == Task::rest && plan.layer != "picture" && !layer_of(plan, frame))
        session.complain(text("the model phong has no layer ", plan.layer, ": this is the picture"));
    if (plan.is_compared)
        session.drawn(plan, std::move(frame.radiance));
    session.done(plan, ms_since(start));
}

// As long as there is something new to be seen by: a picture takes its time to be made and to be sent.
void Desk::trace(const Plan& plan, Session& session)
{
    constexpr auto step = std::chrono::milliseconds(400);
    const Clock::time_point start = Clock::now();
    const bool finished = plan.trace->advance([&](const reference::Progress&) {
        if (ending_ || session.is_stale(plan))
            throw Overtaken{false};
        return Clock::now() - start < step && !others_wait(session);
    });
    Picture picture = plan.trace->picture();
    complete(plan, ms_since(start), picture);
    session.presenter().show(std::move(picture));
    if (finished)
        session.traced(plan);
}

void Desk::carry_out(const Plan& plan, Session& session, std::chrono::milliseconds slice)
{
    try {
        if (plan.task == Task::trace)
            trace(plan, session);
        else
            draw(plan, session, slice);
        set_slice(session, false);
    } catch (const Overtaken& overtaken) {
        session.failed(plan, "");
        if (overtaken.by_others)
            set_slice(session, true);
    } catch (const std::bad_alloc&) {
        session.failed(plan, "not enough memory for the picture");
    } catch (const std::exception& error) {
        session.failed(plan, one_line(error.what()));
    }
}

} // namespace lambent::viewer
