#include "tests/view_window/desktop.h"

#include "base/text.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

namespace lambent::testing {
namespace {

using Clock = std::chrono::steady_clock;

void sleep_ms(int milliseconds)
{
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

bool is_installed(const std::string& program)
{
    return run_program("sh", {"-c", text("command -v ", program)}).code == 0;
}

std::string contents(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// The number at a place of an XWD header: 32 bits, the highest first.
std::uint32_t number(const std::string& bytes, std::size_t index)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[4 * index + i]);
    return value;
}

} // namespace

Running::Running(const std::vector<std::string>& words, const std::string& output)
{
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (const std::string& word : words)
        pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    process_ = fork();
    if (process_ == 0) {
        const int file = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        dup2(file, 1);
        dup2(file, 2);
        execvp(pointers[0], pointers.data());
        _exit(127);
    }
}

Running::~Running()
{
    if (process_ <= 0)
        return;
    kill(process_, SIGTERM);
    if (wait(10.0) < 0) {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
}

int Running::wait(double seconds)
{
    const auto end = Clock::now() + std::chrono::duration<double>(seconds * patience);
    int status = 0;
    while (waitpid(process_, &status, WNOHANG) == 0) {
        if (Clock::now() > end)
            return -1;
        sleep_ms(20);
    }
    process_ = -1;
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

void Running::signal(int number) const
{
    kill(process_, number);
}

// [proc(5), /proc/pid/stat] Fields 14 and 15, after the program's name in parentheses, which is the second.
double Running::busy_seconds() const
{
    const std::string stat = contents(text("/proc/", process_, "/stat"));
    const std::size_t name_end = stat.rfind(')');
    if (name_end == std::string::npos)
        return 0.0;
    std::istringstream fields(stat.substr(name_end + 1));
    std::string skipped;
    for (int field = 3; field < 14; ++field)
        fields >> skipped;
    double user = 0.0, system = 0.0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double Screenshot::mean(const Area& area) const
{
    double sum = 0.0;
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int i = 3 * area.x; i < 3 * (area.x + area.width); ++i)
            sum += rgb[static_cast<std::size_t>(3 * y * width + i)];
    return sum / (3.0 * area.width * area.height);
}

double Screenshot::difference(const Screenshot& other, const Area& area) const
{
    double sum = 0.0;
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int i = 3 * area.x; i < 3 * (area.x + area.width); ++i) {
            const auto at = static_cast<std::size_t>(3 * y * width + i);
            sum += std::abs(int{rgb[at]} - int{other.rgb[at]});
        }
    return sum / (3.0 * area.width * area.height);
}

double Screenshot::redness(const Area& area) const
{
    int red = 0;
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x) {
            const auto at = static_cast<std::size_t>(3 * (y * width + x));
            red += rgb[at] > 180 && rgb[at] > rgb[at + 1] + 60 && rgb[at] > rgb[at + 2] + 60;
        }
    return red / (1.0 * area.width * area.height);
}

std::unique_ptr<Desktop> Desktop::open(std::string& why, const std::string& more)
{
    for (const char* program : {"Xvfb", "xdotool"})
        if (!is_installed(program)) {
            why = text("no ", program);
            return nullptr;
        }
    auto desktop = std::make_unique<Desktop>();
    const std::string number = desktop->folder_.path("display"), log = desktop->folder_.path("xvfb.log");
    // Xvfb chooses a free display and says which when it is ready; its screen is a file.
    desktop->server_ = std::make_unique<Running>(
        std::vector<std::string>{"sh", "-c",
                                 text("exec Xvfb -displayfd 3 -screen 0 1280x800x24 ", more, " -fbdir '",
                                      desktop->folder_.path("."), "' 3> '", number, "'")},
        log);
    for (int i = 0; i < 500 * patience && contents(number).find('\n') == std::string::npos; ++i)
        sleep_ms(20);
    const std::string said = contents(number);
    if (said.find('\n') == std::string::npos) {
        why = text("Xvfb does not start: ", one_line(contents(log)));
        return nullptr;
    }
    desktop->display_ = text(":", said.substr(0, said.find('\n')));
    return desktop;
}

bool Desktop::act(const std::vector<std::string>& words) const
{
    std::vector<std::string> all = {text("DISPLAY=", display_), "xdotool"};
    all.insert(all.end(), words.begin(), words.end());
    return run_program("env", all).code == 0;
}

// [X Window dump, XWDFile.h] The server keeps it in its own order of bytes, 32 bits a pixel.
Screenshot Desktop::look(int rows) const
{
    std::ifstream file(folder_.path("Xvfb_screen0"), std::ios::binary);
    std::string header(100, '\0');
    Screenshot shot;
    if (!file.read(header.data(), static_cast<std::streamsize>(header.size())))
        return shot;
    shot.width = static_cast<int>(number(header, 4));
    shot.height = std::min(static_cast<int>(number(header, 5)), rows);
    const std::size_t start = number(header, 0) + 12 * number(header, 19), pitch = number(header, 12);
    std::string bytes(pitch * static_cast<std::size_t>(shot.height), '\0');
    file.seekg(static_cast<std::streamoff>(start));
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    shot.rgb.resize(static_cast<std::size_t>(3 * shot.width * shot.height));
    unsigned char* to = shot.rgb.data();
    for (int y = 0; y < shot.height; ++y) {
        const char* from = bytes.data() + static_cast<std::size_t>(y) * pitch;
        for (int x = 0; x < shot.width; ++x, from += 4, to += 3)
            for (int c = 0; c < 3; ++c)
                to[c] = static_cast<unsigned char>(from[2 - c]);
    }
    return shot;
}

Screenshot Desktop::look_at_rest(double seconds, const Running& program) const
{
    constexpr double step = 0.25;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds * patience);
    Screenshot last = look();
    double busy = program.busy_seconds();
    for (int quiet = 0; quiet < 4 && Clock::now() < end;) {
        sleep_ms(static_cast<int>(1000.0 * step));
        Screenshot next = look();
        const double busy_now = program.busy_seconds();
        // Who draws slowly shows nothing new for long between two pictures, but is at work.
        quiet = next.rgb == last.rgb && busy_now - busy < 0.2 * step ? quiet + 1 : 0;
        last = std::move(next), busy = busy_now;
    }
    return last;
}

} // namespace lambent::testing
