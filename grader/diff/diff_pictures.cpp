#include "diff/diff.h"

#include "report/printer.h"

#include <cmath>
#include <cstdlib>

namespace testat {
namespace {
constexpr Term other_size{"verschieden groß: {} x {} und {} x {}\n", "of different sizes: {} x {} and {} x {}\n"};
constexpr Term same{"gleich\n", "the same\n"};
constexpr Term differ{"{} von {} Pixeln verschieden, höchstens um {} von 255, RMS {:.3f}\n",
                      "{} of {} pixels differ, by {} of 255 at most, RMS {:.3f}\n"};
}  // namespace

Difference diff_pictures(Bitmap const& a, Bitmap const& b, Language language)
{
    if (a.width != b.width || a.height != b.height)
        return {false, fmt::format(fmt::runtime(say(other_size, language)), a.width, a.height, b.width, b.height)};
    std::size_t pixels = 0;
    int most = 0;
    double squares = 0;
    constexpr std::size_t channels = 4;
    for (std::size_t i = 0; i < a.rgba.size(); i += channels) {
        int most_here = 0;
        for (std::size_t c = i; c < i + channels; ++c) {
            int const difference = std::abs(int(a.rgba[c]) - int(b.rgba[c]));
            squares += difference * difference;
            most_here = std::max(most_here, difference);
        }
        pixels += most_here > 0 ? 1 : 0;
        most = std::max(most, most_here);
    }
    if (pixels == 0)
        return {true, say(same, language)};
    double const rms = std::sqrt(squares / double(a.rgba.size()));
    return {false, fmt::format(fmt::runtime(say(differ, language)), pixels, a.rgba.size() / channels, most, rms)};
}
}  // namespace testat
