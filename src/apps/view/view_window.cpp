#include "apps/view/view_window.h"

#include "apps/cli/console.h"
#include "apps/cli/threads.h"
#include "apps/view/canvas.h"
#include "apps/view/hands.h"
#include "apps/view/memory.h"
#include "apps/view/panel.h"
#include "apps/view/screen.h"
#include "apps/view/window.h"
#include "apps/viewer/desk.h"
#include "apps/viewer/load_first.h"
#include "base/error.h"
#include "base/file.h"
#include "base/text.h"

#include <GLFW/glfw3.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <vector>

namespace lambent::view_window {
namespace {

constexpr std::size_t most_memory = 65536; // bytes of the settings file

Memory remembered(cli::Console& console)
{
    const std::optional<std::filesystem::path> file = memory_file();
    std::error_code ignored;
    if (!file || !std::filesystem::exists(*file, ignored))
        return {};
    std::string complaint;
    Memory memory;
    try {
        const auto bytes = read_file(*file, most_memory);
        memory = read_memory(std::string(bytes.begin(), bytes.end()), complaint);
    } catch (const Error& error) {
        complaint = error.what();
    }
    if (!complaint.empty())
        console.warn({text(file->string(), ": ", complaint)});
    return memory;
}

// Where it cannot be kept the next window starts as usual: no reason to fail.
void remember(const Memory& memory)
{
    const std::optional<std::filesystem::path> file = memory_file();
    if (!file)
        return;
    try {
        std::filesystem::create_directories(file->parent_path());
        const std::string json = write_memory(memory);
        write_file(*file, {reinterpret_cast<const std::uint8_t*>(json.data()), json.size()});
    } catch (const std::exception&) {
    }
}

// A name that is not there yet: picture.png, picture-2.png, ...
std::string free_name(const std::string& name)
{
    const std::filesystem::path path(name);
    std::string free = name;
    for (int i = 2; std::filesystem::exists(free) && i < 10000; ++i)
        free = text(path.stem().string(), "-", i, path.extension().string());
    return free;
}

// The window's thread; pictures are drawn by the desk's.
class View {
public:
    View(viewer::Wish start, const Memory& memory, viewer::Stock& stock)
        : window_(text(start.scene, " - lambent"), memory.place), desk_(stock),
          screen_(std::make_shared<Screen>()), state_{memory.panel, false}
    {
        const Window::Pixels pixels = window_.pixels();
        viewer::set_size(start, pixels.width, pixels.height);
        session_ = std::make_shared<viewer::Session>(start, stock, screen_);
        desk_.add(session_);
    }

    ~View() { desk_.remove(session_); }
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    Memory run()
    {
        while (!window_.closing()) {
            window_.wait(0.25);
            // Dear ImGui answers to an input in the frame after it.
            for (int frame = 0; frame < 2; ++frame)
                draw();
        }
        return {window_.place(), state_.panel};
    }

private:
    void draw()
    {
        take_news();
        follow_size();
        open(window_.take_dropped());
        window_.begin();
        canvas_.draw();
        try {
            act(show_panels(*session_, shown_, state_), move(*session_, window_.take_keys()));
        } catch (const Error& error) {
            shown_.notice = error.what();
        }
        window_.end();
        desk_.nudge();
    }

    void act(const Pressed& pressed, const Asked& asked)
    {
        if (asked.close)
            glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE);
        if (asked.panel)
            state_.panel = !state_.panel;
        if (asked.help)
            state_.help = !state_.help;
        if (pressed.reset)
            session_->reset(0);
        if (pressed.copy || asked.copy) {
            glfwSetClipboardString(window_.handle(), shown_.command.c_str());
            shown_.notice = "the command was copied";
        }
        if (pressed.save || asked.save)
            session_->save("png");
    }

    void take_news()
    {
        Screen::News news = screen_->take();
        for (int i = 0; i < news.shown; ++i)
            session_->seen();
        if (news.picture) {
            canvas_.set(news.picture->codes);
            shown_.kind = news.picture->kind;
            shown_.width = news.picture->codes.width;
            shown_.height = news.picture->codes.height;
            shown_.scale = news.picture->scale;
            shown_.draw_ms = news.picture->draw_ms;
        }
        if (news.state) {
            const nlohmann::json state = nlohmann::json::parse(*news.state);
            shown_.loading = state["loading"];
            shown_.error = state["error"];
        }
        shown_.command = viewer::command_of(session_->wish(), "picture.png");
        if (news.saved)
            write(*news.saved);
    }

    void write(const viewer::Saved& saved)
    {
        try {
            const std::string name = free_name(saved.name);
            write_file(name, saved.bytes);
            shown_.notice = text("saved as ", name);
        } catch (const Error& error) {
            shown_.notice = error.what();
        }
    }

    void follow_size()
    {
        const Window::Pixels pixels = window_.pixels();
        viewer::Wish wanted = session_->wish();
        viewer::set_size(wanted, pixels.width, pixels.height);
        if (pixels.width < 1 ||
            (wanted.width == session_->wish().width && wanted.height == session_->wish().height))
            return; // also while it is an icon
        session_->change(0, [&](viewer::Wish& wish, const viewer::Eye::World&) {
            viewer::set_size(wish, pixels.width, pixels.height);
        });
    }

    // What was dropped: a panorama lights, anything else is a model.
    void open(const std::vector<std::string>& names)
    {
        for (const std::string& name : names) {
            std::string extension = std::filesystem::path(name).extension().string();
            std::transform(extension.begin(), extension.end(), extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            if (extension == ".hdr" || extension == ".exr")
                session_->open_environment(name);
            else
                session_->open_scene(name);
        }
    }

    Window window_;
    Canvas canvas_;
    viewer::Desk desk_;
    std::shared_ptr<Screen> screen_;
    std::shared_ptr<viewer::Session> session_;
    Shown shown_;
    PanelState state_;
};

} // namespace

void run(const cli::ViewArguments& arguments)
{
    const cli::RenderArguments& picture = arguments.start.picture;
    const cli::ThreadLimit limit(picture.common.threads);
    cli::Console console(picture.common.verbosity);
    Memory memory = remembered(console);
    for (const auto& [name, word] : arguments.start.words)
        if (name == "size")
            memory.place = {picture.settings.width, picture.settings.height};
    viewer::Stock stock(
        {picture.cache, picture.backend, [&](const std::string& line) { console.warn({line}); }});
    View view(viewer::load_first(arguments.start, stock, console), memory, stock);
    remember(view.run());
}

} // namespace lambent::view_window
