#include "checks/pictures.h"

#include "envelopes/pictures.h"

#include <algorithm>
#include <cmath>

namespace testat {
namespace {
/// Texels of mip levels this small may not differ at all.
constexpr int small_level_texels = 64;

std::size_t count_outside(Picture const& picture, Envelope const& envelope)
{
    std::size_t outside = 0;
    for (std::size_t i = 0; i < picture.rgb.size() / 3; ++i)
        outside += envelope.is_outside(&picture.rgb[3 * i], i) ? 1 : 0;
    return outside;
}

bool small_levels_differ(Picture const& picture, Envelope const& envelope)
{
    for (int level = 0; level < checker_levels; ++level) {
        LevelPlace const place = place_of_level(level);
        if (place.size.x * place.size.y > small_level_texels)
            continue;
        for (int y = 0; y < place.size.y; ++y)
            for (int x = 0; x < place.size.x; ++x) {
                auto const i = std::size_t((place.corner.y + y) * picture.width + place.corner.x + x);
                if (envelope.is_outside(&picture.rgb[3 * i], i))
                    return true;
            }
    }
    return false;
}

/// Levels that are not there, or of another size, are drawn as NaN.
bool lacks_level(Picture const& picture)
{
    auto const is_drawn = [&](LevelPlace const& place) {
        for (int y = 0; y < place.size.y; ++y)
            for (int x = 0; x < place.size.x; ++x)
                if (!std::isnan(
                        picture.rgb[3 * std::size_t((place.corner.y + y) * picture.width + place.corner.x + x)]))
                    return true;
        return false;
    };
    for (int level = 0; level < checker_levels; ++level)
        if (!is_drawn(place_of_level(level)))
            return true;
    return false;
}

void measure_error(Picture const& picture, Picture const& expected, Comparison& comparison)
{
    double sum = 0;
    for (std::size_t i = 0; i < expected.rgb.size(); ++i) {
        double const error = std::abs(double(picture.rgb[i]) - expected.rgb[i]);
        double const counted = std::isfinite(error) ? error : HUGE_VAL;
        sum += counted * counted;
        comparison.max_error = std::max(comparison.max_error, counted);
    }
    comparison.rms = std::sqrt(sum / double(expected.rgb.size()));
}
}  // namespace

double picture_score(std::size_t outside, std::size_t limit, std::size_t all)
{
    if (outside <= limit)
        return 1;
    double const shift = limit == 0 ? 1 : 0;  // so that one pixel too many already counts
    double const from = double(limit) + shift;
    double const share = std::log((double(outside) + shift) / from) / std::log((double(all) + shift) / from);
    return std::clamp(1 - share, 0.0, 1.0);
}

Comparison compare_picture(std::string const& name, Picture const& picture, Envelope const& envelope)
{
    Comparison comparison;
    std::size_t const all = envelope.expected.rgb.size() / 3;
    comparison.outside = all;
    if (picture.rgb.size() != envelope.expected.rgb.size())
        return comparison;
    comparison.outside = count_outside(picture, envelope);
    bool const strict = name == miplevels && small_levels_differ(picture, envelope);
    comparison.limit = strict ? 0 : std::max<std::size_t>(4, std::size_t(1e-4 * double(all)));
    bool const incomplete = name == miplevels && lacks_level(picture);
    comparison.score = incomplete ? 0 : picture_score(comparison.outside, comparison.limit, all);
    measure_error(picture, envelope.expected, comparison);
    return comparison;
}

Rendering judge_rendering(std::string const& picture, std::string const& group, Observations const& observations,
                          Envelope const& envelope)
{
    Rendering rendering;
    if (auto const* answers = observations.find(group)) {
        rendering.ended = answers->status.ended;
        rendering.picture = read_picture(*answers);
    }
    rendering.comparison = compare_picture(picture, rendering.picture.value_or(Picture{}), envelope);
    return rendering;
}
}  // namespace testat
