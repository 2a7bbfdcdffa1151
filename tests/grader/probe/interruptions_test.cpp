#include "probe/interruptions.h"

#include <sys/resource.h>

#include <gtest/gtest.h>

#include <thread>

namespace testat {
namespace {
#if defined(__SANITIZE_THREAD__)
constexpr bool signals_come_at_once = false;
#else
constexpr bool signals_come_at_once = true;
#endif

/// How many times the calling thread has given up its processor of its own accord.
long stops()
{
    rusage usage = {};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_nvcsw;
}

/// Comes back once the calling thread has been stopped ten times, however busy it is.
void wait_for_stops()
{
    Interruptions const interruptions;
    long const before = stops();
    while (stops() < before + 10) {
    }
}
}  // namespace

TEST(Interruptions, StopABusyThreadAgainAndAgain)
{
    if (!signals_come_at_once)
        GTEST_SKIP() << "the sanitizer keeps signals back";
    wait_for_stops();
}

TEST(Interruptions, StopEachThreadThatHasSome)
{
    if (!signals_come_at_once)
        GTEST_SKIP() << "the sanitizer keeps signals back";
    std::thread other(wait_for_stops);
    wait_for_stops();
    other.join();
}
}  // namespace testat
