#include "apps/view/view.h"

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace lambent::view_window {
namespace {

using viewer::Clock;

constexpr std::chrono::seconds notice_lasts{8}, refusal_lasts{30}, rate_over{1};

// The first of picture.png, picture-2.png, ... that does not exist.
std::string free_name(const std::string& name)
{
    const std::filesystem::path path(name);
    std::error_code ignored;
    std::string free = name;
    for (int i = 2; std::filesystem::exists(std::filesystem::symlink_status(free, ignored)); ++i)
        free = text(path.stem().string(), "-", i, path.extension().string());
    return free;
}

// The title has no folders, which could hide the name.
std::string title_of(const std::string& scene)
{
    return text(std::filesystem::path(scene).filename().string(), " - lambent");
}

} // namespace

View::View(viewer::ViewRequest start, const WindowSettings& settings, viewer::FileList files,
           viewer::AssetCache& assets)
    : window_(title_of(start.asked.scene), settings.place), scheduler_(assets),
      screen_(std::make_shared<Screen>()), panels_(std::move(files), settings.panel)
{
    const Window::Pixels pixels = window_.pixels();
    viewer::set_size(start, pixels.width, pixels.height);
    session_ = std::make_shared<viewer::Session>(start, assets, screen_);
    scheduler_.add(session_);
}

View::~View()
{
    scheduler_.remove(session_);
}

WindowSettings View::run(const std::function<bool()>& stopped)
{
    // Dear ImGui reacts to input one frame later: without new input two more frames are drawn, then four per second.
    for (int due = 2; !is_done(stopped()); --due) {
        if (window_.listen(due > 0 ? 0.0 : 0.25))
            due = 2;
        draw();
    }
    return {window_.place(), panels_.is_open};
}

bool View::is_done(bool stopped)
{
    if (!stopped && !window_.closing()) {
        shown_.ending = false;
        return false;
    }
    const Clock::time_point now = Clock::now();
    if (!std::exchange(shown_.ending, true)) {
        ending_ = now;
        unsaved_.clear();
    }
    take_news();
    if (!unsaved_.empty() && stopped)
        throw Error(Failure::cannot_write, unsaved_);
    if (!unsaved_.empty())
        window_.stay();
    return unsaved_.empty() && (!shown_.saving || now - ending_ > patience);
}

void View::draw()
{
    take_news();
    follow_size();
    for (const std::string& name : window_.take_dropped())
        openings_.push_back(opening_of(name));
    open_next();
    window_.begin();
    canvas_.draw();
    try {
        const Pressed pressed = panels_.show(*session_, shown_);
        if (!pressed.refusal.empty())
            refuse(pressed.refusal);
        move_by_mouse(*session_);
        act(pressed, press_keys(*session_, window_.take_keys()));
    } catch (const Error& error) {
        refuse(error.what());
    }
    window_.end();
    scheduler_.nudge();
}

void View::act(const Pressed& pressed, const Asked& asked)
{
    if (asked.close)
        window_.close();
    panels_.is_open ^= asked.panel;
    panels_.help ^= asked.help || pressed.help;
    if (asked.leave)
        panels_.leave();
    if (pressed.opening)
        openings_.push_back(*pressed.opening);
    if (pressed.reset)
        session_->reset(0);
    if (pressed.copy || asked.copy) {
        window_.copy(shown_.command);
        notice("The command was copied.");
    }
    if (pressed.save || asked.save) {
        session_->save("png");
        ++awaited_;
    }
}

void View::take_news()
{
    shown_.saving = session_->is_saving(); // before take(), which then has all pictures saved so far
    const Screen::News news = screen_->take();
    for (int i = 0; i < news.shown; ++i)
        session_->seen();
    if (news.picture)
        take_picture(*news.picture);
    if (news.state)
        take_state(*news.state);
    for (const viewer::Saved& saved : news.saved)
        write(saved);
    if (awaited_ > 0 && !shown_.saving) {
        awaited_ = 0;
        give_up_saving(nlohmann::json::parse(session_->state(), nullptr, false).value("error", ""));
    }
    shown_.command = viewer::command_of(session_->shown(), "picture.png");
    if (Clock::now() - noticed_ > notice_lasts)
        shown_.notice.clear();
    if (Clock::now() - refused_ > refusal_lasts)
        shown_.refusal.clear();
}

void View::take_picture(const viewer::ShownPicture& picture)
{
    canvas_.set(picture.codes);
    shown_.kind = picture.kind;
    shown_.width = picture.codes.width;
    shown_.height = picture.codes.height;
    shown_.scale = picture.scale;
    shown_.draw_ms = picture.draw_ms;
    shown_.traced = picture.traced;
    shown_.is_last = picture.is_last;
    shown_.lacks_shadows = picture.lacks_shadows;
    shown_.measured = picture.error;
    const Clock::time_point now = Clock::now();
    if (picture.kind == viewer::ShownPicture::Kind::moving)
        recent_.push_back(now);
    while (!recent_.empty() && now - recent_.front() > rate_over)
        recent_.pop_front();
    const double seconds =
        recent_.empty() ? 0.0 : std::chrono::duration<double>(now - recent_.front()).count();
    shown_.rate = recent_.size() > 2 ? static_cast<double>(recent_.size() - 1) / seconds : 0.0;
}

void View::take_state(const std::string& words)
{
    const nlohmann::json state = nlohmann::json::parse(words, nullptr, false);
    shown_.loading = state.value("loading", false);
    shown_.error = state.value("error", "");
    shown_.warnings = state.value("warnings", std::vector<std::string>());
    window_.set_title(title_of(session_->request().asked.scene));
}

void View::write(const viewer::Saved& saved)
{
    awaited_ = std::max(awaited_ - 1, 0);
    try {
        const std::string name = free_name(saved.name);
        write_file(name, saved.bytes);
        notice(text("Saved as ", name, "."));
    } catch (const Error& error) {
        give_up_saving(error.what());
    }
}

// The session's own line may already begin with this.
void View::give_up_saving(const std::string& why)
{
    constexpr std::string_view begin = "the picture was not saved: ";
    unsaved_ = text("The picture was not saved: ", why.starts_with(begin) ? why.substr(begin.size()) : why);
    refuse(unsaved_);
}

void View::follow_size()
{
    const Window::Pixels pixels = window_.pixels();
    viewer::ViewRequest wanted = session_->request();
    const cli::RenderArguments now = wanted.asked;
    viewer::set_size(wanted, pixels.width, pixels.height);
    const draw::Settings& settings = wanted.asked.settings;
    if (pixels.width < 1 || (settings.width == now.settings.width && settings.height == now.settings.height))
        return; // the size is 0 while the window is minimised
    session_->change(0, [&](viewer::ViewRequest& request, const viewer::OrbitCamera::World&) {
        viewer::set_size(request, pixels.width, pixels.height);
    });
}

// Opens queued files one after the other, as the session opens one at a time.
void View::open_next()
{
    if (openings_.empty() || session_->is_opening())
        return;
    const Opening next = openings_.front();
    openings_.pop_front();
    if (next.is_environment)
        session_->open_environment(next.name);
    else
        session_->open_scene(next.name);
}

void View::notice(const std::string& line)
{
    shown_.notice = line;
    shown_.refusal.clear();
    noticed_ = Clock::now();
}

void View::refuse(const std::string& line)
{
    shown_.refusal = line;
    shown_.notice.clear();
    refused_ = Clock::now();
}

} // namespace lambent::view_window
