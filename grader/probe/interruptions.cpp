#include "probe/interruptions.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <ctime>
#include <system_error>

namespace testat {
namespace {
constexpr long between_ns = 20'000;

thread_local timer_t timer;
thread_local volatile std::sig_atomic_t is_wanted = 0;

/// Once: set anew after each stop, or a slow machine would do nothing but stop.
void set_timer()
{
    itimerspec const soon{{0, 0}, {0, between_ns}};
    timer_settime(timer, 0, &soon, nullptr);
}

void stop_for_a_moment(int)
{
    if (is_wanted == 0)
        return;
    int const kept = errno;
    timespec const shortest{0, 1};
    nanosleep(&shortest, nullptr);
    set_timer();
    errno = kept;
}

void handle_signal()
{
    struct sigaction action = {};
    action.sa_handler = stop_for_a_moment;
    action.sa_flags = SA_RESTART;
    sigaction(SIGALRM, &action, nullptr);
}
}  // namespace

Interruptions::Interruptions()
{
    handle_signal();
    sigevent event = {};
    event.sigev_notify = SIGEV_THREAD_ID;
    event.sigev_signo = SIGALRM;
    event._sigev_un._tid = gettid();
    if (timer_create(CLOCK_MONOTONIC, &event, &timer) != 0)
        throw std::system_error(errno, std::generic_category(), "timer for interruptions");
    is_wanted = 1;
    set_timer();
}

Interruptions::~Interruptions()
{
    is_wanted = 0;
    timer_delete(timer);
}
}  // namespace testat
