#include "apps/cli/interrupt.h"

#include <csignal>
#include <cstdlib>

#include <signal.h>

namespace lambent::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void note(int signal)
{
    interrupted = signal;
}

} // namespace

Interrupt::Interrupt()
{
    interrupted = 0;
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = static_cast<int>(SA_RESETHAND); // the next one is not caught
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
