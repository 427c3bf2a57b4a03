#include "apps/viewer/draw_state.h"

#include <algorithm>

namespace lambent::viewer {

void DrawState::request_view()
{
    const std::lock_guard lock(mutex_);
    ++values_.serial;
    values_.stage = Stage::requested;
}

void DrawState::picture_finished(Serial serial, Stage stage)
{
    const std::lock_guard lock(mutex_);
    if (serial == values_.serial)
        values_.stage = std::max(values_.stage, stage);
}

void DrawState::request_failed(Serial serial)
{
    picture_finished(serial, Stage::finished);
}

void DrawState::picture_started()
{
    const std::lock_guard lock(mutex_);
    ++values_.in_flight;
}

void DrawState::picture_left()
{
    const std::lock_guard lock(mutex_);
    values_.in_flight = std::max(values_.in_flight - 1, 0);
}

void DrawState::save_requested()
{
    const std::lock_guard lock(mutex_);
    ++values_.unsaved;
}

void DrawState::save_finished()
{
    const std::lock_guard lock(mutex_);
    --values_.unsaved;
}

void DrawState::set_drawable(bool drawable)
{
    const std::lock_guard lock(mutex_);
    values_.drawable = drawable;
}

void DrawState::set_animated(bool animated)
{
    const std::lock_guard lock(mutex_);
    values_.animated = animated;
}

void DrawState::close()
{
    const std::lock_guard lock(mutex_);
    values_.closed = true;
}

DrawState::Serial DrawState::serial() const
{
    const std::lock_guard lock(mutex_);
    return values_.serial;
}

DrawState::Stage DrawState::stage() const
{
    const std::lock_guard lock(mutex_);
    return values_.stage;
}

int DrawState::unsaved() const
{
    const std::lock_guard lock(mutex_);
    return values_.unsaved;
}

bool DrawState::is_closed() const
{
    const std::lock_guard lock(mutex_);
    return values_.closed;
}

bool DrawState::is_current(Serial serial) const
{
    const std::lock_guard lock(mutex_);
    return serial == values_.serial;
}

bool DrawState::can_show_more() const
{
    const std::lock_guard lock(mutex_);
    return values_.in_flight < most_in_flight;
}

bool DrawState::waits_for_moving_picture() const
{
    const std::lock_guard lock(mutex_);
    const bool has_moved = values_.animated || values_.stage == Stage::requested;
    return !values_.closed && values_.drawable && has_moved && values_.in_flight < most_in_flight;
}

} // namespace lambent::viewer
