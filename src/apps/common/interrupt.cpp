#include "apps/common/interrupt.h"

#include <csignal>
#include <cstdlib>

#include <signal.h>
#include <time.h>

namespace lambent::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;
timespec first{};

// A second signal ends the program at once, but not within half a second of the first: `timeout` sends every signal
// twice, to the program and to its process group.
void note(int signal)
{
    constexpr double moment = 0.5; // seconds
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    if (interrupted == 0) {
        first = now;
        interrupted = signal;
    } else if (static_cast<double>(now.tv_sec - first.tv_sec) +
                   1e-9 * static_cast<double>(now.tv_nsec - first.tv_nsec) >
               moment) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

} // namespace

Interrupt::Interrupt()
{
    interrupted = 0;
    struct sigaction action {};
    action.sa_handler = note;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

Interrupt::~Interrupt()
{
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool Interrupt::asked() const
{
    return interrupted != 0;
}

void Interrupt::end_program() const
{
    const int signal = interrupted;
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    std::_Exit(128 + signal); // where the signal is blocked
}

} // namespace lambent::cli
