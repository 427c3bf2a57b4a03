#include "apps/common/console.h"

#include "base/text.h"

#include <cstdio>

#include <unistd.h>

namespace lambent::cli {
namespace {

constexpr double first_shown_seconds = 1.0, between_seconds = 0.1;
constexpr int bar_width = 40;

double seconds(std::chrono::steady_clock::duration d)
{
    return std::chrono::duration<double>(d).count();
}

} // namespace

Console::Console(Verbosity verbosity) : verbosity_(verbosity), terminal_(isatty(STDERR_FILENO) != 0) {}

void Console::warn(const Warnings& warnings) const
{
    if (verbosity_ == Verbosity::quiet)
        return;
    for (const std::string& line : warnings)
        std::fprintf(stderr, "lambent: warning: %s\n", one_line(line).c_str());
}

void Console::warn_of_input(const Warnings& warnings, const CommonOptions& common) const
{
    if (common.strict)
        refuse_warnings(warnings);
    warn(warnings);
}

void Console::remark(const std::string& line) const
{
    if (verbosity_ == Verbosity::verbose)
        std::fprintf(stderr, "lambent: %s\n", one_line(line).c_str());
}

void Console::progress(float done, const std::string& note)
{
    const Clock::time_point now = Clock::now();
    if (!terminal_ || verbosity_ == Verbosity::quiet || seconds(now - start_) < first_shown_seconds ||
        (shown_ && seconds(now - last_) < between_seconds))
        return;
    last_ = now;
    shown_ = true;
    char bar[bar_width + 1] = {};
    for (int i = 0; i < bar_width; ++i)
        bar[i] = static_cast<float>(i) < done * bar_width ? '#' : '.';
    const double left = seconds(now - start_) * (1.0 / static_cast<double>(done) - 1.0);
    std::fprintf(stderr, "\r[%s] %3.0f%%, %.0f s left%s%s \033[K", bar, static_cast<double>(done) * 100.0,
                 left, note.empty() ? "" : ", ", note.c_str());
    std::fflush(stderr);
}

void Console::end_progress()
{
    if (shown_)
        std::fputs("\r\033[K", stderr);
    shown_ = false;
}

void refuse_warnings(const Warnings& warnings)
{
    if (warnings.empty())
        return;
    const std::size_t more = warnings.size() - 1;
    throw Error(Failure::bad_input,
                text(warnings.front(),
                     more == 0 ? "" : text(" (and ", more, more == 1 ? " warning" : " warnings", " more)")));
}

} // namespace lambent::cli
