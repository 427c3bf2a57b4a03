#include "tests/view_window/dropping.h"

#include "tests/support/process.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <array>
#include <chrono>
#include <memory>
#include <string_view>
#include <thread>

namespace lambent::testing {
namespace {

constexpr long xdnd_version = 5;

// "file:///a%20b", a line each. [RFC 3986, RFC 2483]
std::string uri_list(const std::vector<std::string>& files)
{
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string list;
    for (const std::string& file : files) {
        list += "file://";
        for (const char c : file) {
            const auto byte = static_cast<unsigned char>(c);
            if (plain.find(c) != std::string_view::npos)
                list += c;
            else
                (list += '%', list += digits[byte / 16]) += digits[byte % 16];
        }
        list += "\r\n";
    }
    return list;
}

// A program with a window that nobody sees, which has files to give.
class Source {
public:
    Source(Display* display, Window target)
        : display_(display), target_(target),
          window_(XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0))
    {
        XSetSelectionOwner(display_, atom("XdndSelection"), window_, CurrentTime);
    }
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;
    ~Source() { XDestroyWindow(display_, window_); }

    std::string drop(const std::string& list)
    {
        const Atom type = atom("text/uri-list");
        constexpr long x = 200, y = 200;
        send("XdndEnter", {xdnd_version << 24, static_cast<long>(type), 0, 0});
        send("XdndPosition", {0, x << 16 | y, CurrentTime, static_cast<long>(atom("XdndActionCopy"))});
        if (!answer("XdndStatus", list))
            return "the window does not answer";
        if ((answered_[1] & 1) == 0)
            return "the window does not take files";
        send("XdndDrop", {0, CurrentTime, 0, 0});
        return answer("XdndFinished", list) ? "" : "the window does not fetch the files";
    }

private:
    Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

    // Every message begins with who sends it.
    void send(const char* type, const std::array<long, 4>& rest) const
    {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target_;
        event.xclient.message_type = atom(type);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(window_);
        for (std::size_t i = 0; i < rest.size(); ++i)
            event.xclient.data.l[i + 1] = rest[i];
        XSendEvent(display_, target_, False, NoEventMask, &event);
        XFlush(display_);
    }

    // Waits for a message, and gives the list meanwhile if that is asked for.
    bool answer(const char* type, const std::string& list)
    {
        const Atom wanted = atom(type);
        for (int i = 0; i < 1000 * patience; ++i) {
            while (XPending(display_) > 0) {
                XEvent event;
                XNextEvent(display_, &event);
                if (event.type == SelectionRequest)
                    give(event.xselectionrequest, list);
                if (event.type == ClientMessage && event.xclient.message_type == wanted) {
                    answered_ = {event.xclient.data.l[0], event.xclient.data.l[1]};
                    return true;
                }
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }

    void give(const XSelectionRequestEvent& request, const std::string& list) const
    {
        XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(list.data()), static_cast<int>(list.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &event);
        XFlush(display_);
    }

    Display* display_;
    Window target_, window_;
    std::array<long, 2> answered_{};
};

// Of those that stand on the screen themselves; 0: none.
Window window_titled(Display* display, const std::string& title)
{
    Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    if (!XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count))
        return 0;
    Window found = 0;
    for (unsigned i = 0; i < count; ++i) {
        char* name = nullptr;
        if (XFetchName(display, children[i], &name) && name == title)
            found = children[i];
        XFree(name);
    }
    XFree(children);
    return found;
}

} // namespace

std::string drop(const std::string& display, const std::string& title, const std::vector<std::string>& files)
{
    const std::unique_ptr<Display, int (*)(Display*)> connection(XOpenDisplay(display.c_str()),
                                                                 &XCloseDisplay);
    if (!connection)
        return "no display";
    const Window target = window_titled(connection.get(), title);
    if (!target)
        return "no window is titled " + title;
    return Source(connection.get(), target).drop(uri_list(files));
}

} // namespace lambent::testing
