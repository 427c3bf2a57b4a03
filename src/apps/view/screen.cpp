#include "apps/view/screen.h"

#include "apps/view/window.h"

#include <utility>

namespace lambent::view_window {

void Screen::show(viewer::ShownPicture picture)
{
    {
        const std::lock_guard lock(mutex_);
        news_.picture = std::move(picture);
        ++news_.shown;
    }
    Window::wake();
}

void Screen::say(const std::string& state)
{
    {
        const std::lock_guard lock(mutex_);
        news_.state = state;
    }
    Window::wake();
}

void Screen::save(viewer::Saved saved)
{
    {
        const std::lock_guard lock(mutex_);
        news_.saved.push_back(std::move(saved));
    }
    Window::wake();
}

Screen::News Screen::take()
{
    const std::lock_guard lock(mutex_);
    return std::exchange(news_, {});
}

} // namespace lambent::view_window
