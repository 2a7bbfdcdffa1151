#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace testat {
namespace {
constexpr std::size_t bar_columns = 24;
constexpr char clear_line[] = "\r\x1b[K";
}  // namespace

std::string progress_line(std::string const& title, std::size_t done, std::size_t steps, double seconds,
                          std::string const& name)
{
    std::size_t const filled = steps == 0 ? bar_columns : std::min(bar_columns, bar_columns * done / steps);
    std::string const left =
        done == 0 || done >= steps
            ? ""
            : fmt::format("  {:.0f} s left", std::ceil(seconds / double(done) * double(steps - done)));
    return fmt::format("{}  [{}{}]  {}/{}{}  {}", title, std::string(filled, '#'),
                       std::string(bar_columns - filled, '-'), done, steps, left, name);
}

Progress::Progress(std::string title, std::size_t steps)
    : title_(std::move(title)), steps_(steps), on_terminal_(isatty(STDERR_FILENO) == 1)
{
}

Progress::~Progress()
{
    if (on_terminal_ && done_ > 0)
        std::fputs("\n", stderr);
}

void Progress::step(std::string const& name)
{
    ++done_;
    std::chrono::duration<double> const seconds = std::chrono::steady_clock::now() - start_;
    std::string const line = on_terminal_ ? clear_line + progress_line(title_, done_, steps_, seconds.count(), name)
                                          : fmt::format("{} {}/{}  {}\n", title_, done_, steps_, name);
    std::fputs(line.c_str(), stderr);
    std::fflush(stderr);
}
}  // namespace testat
