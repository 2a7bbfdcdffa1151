#include "report/pictures.h"

#include "envelopes/pictures.h"
#include "report/png.h"
#include "report/report.h"

#include <fcntl.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace testat {
namespace {
struct Rgb {
    double r, g, b;
};

/// Stops of the scale, by the logarithm of the difference from 1/256 to 1.
constexpr Rgb scale[] = {
    {0.00, 0.10, 0.35}, {0.25, 0.30, 0.45}, {0.50, 0.49, 0.47}, {0.75, 0.68, 0.38}, {1.00, 0.90, 0.20}};

Rgb colour_of(int difference_8_bits)
{
    if (difference_8_bits == 0)
        return {0, 0, 0};
    constexpr int intervals = int(std::size(scale)) - 1;
    double const position = std::log2(difference_8_bits) / 8 * intervals;
    int const i = std::min(static_cast<int>(position), intervals - 1);
    double const f = position - i;
    auto const mix = [f](double a, double b) { return a + f * (b - a); };
    return {mix(scale[i].r, scale[i + 1].r), mix(scale[i].g, scale[i + 1].g), mix(scale[i].b, scale[i + 1].b)};
}

/// The largest difference of a channel as it is shown.
Rgb difference_of(float const* a, float const* b)
{
    int largest = 0;
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(a[c]))
            return {1, 1, 1};
        largest = std::max(largest, std::abs(int(to_8_bits(a[c], true)) - int(to_8_bits(b[c], true))));
    }
    return colour_of(largest);
}

bool is_same(Picture const& a, Picture const& b)
{
    return a.rgb.size() == b.rgb.size() && std::memcmp(a.rgb.data(), b.rgb.data(), 4 * a.rgb.size()) == 0;
}

std::string file_name(PictureResult const& result, PictureKind kind)
{
    constexpr char const* kinds[] = {"isolated", "submitted", "expected", "difference"};
    return result.name + "." + kinds[static_cast<int>(kind)] + ".png";
}

/// Null if there is none. The isolated one is that of the function for which the picture is worst.
Picture const* rendering(PictureResult const& result, PictureKind kind)
{
    IsolatedPicture const* const isolated = worst(result);
    bool const alone = kind == PictureKind::isolated && isolated != nullptr && isolated->rendering;
    auto const& chosen = alone ? isolated->rendering : result.submitted;
    return chosen && chosen->picture ? &*chosen->picture : nullptr;
}

bool has_own_file(PictureResult const& result, PictureKind kind)
{
    Picture const* const picture = rendering(result, kind);
    return picture != nullptr && !is_same(*picture, result.expected);
}

/// The old directory is there until the new one takes its name.
void replace_directory(std::filesystem::path const& fresh, std::filesystem::path const& old)
{
    if (renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, old.c_str(), RENAME_EXCHANGE) == 0) {
        std::filesystem::remove_all(fresh);
        return;
    }
    std::filesystem::remove_all(old);  // not there, or on a file system that cannot exchange
    std::filesystem::rename(fresh, old);
}

void write_picture(PictureResult const& result, PictureKind kind, std::filesystem::path const& directory)
{
    if (!has_own_file(result, kind))
        return;
    Picture const& picture = *rendering(result, kind);
    write_file(directory / file_name(result, kind), kind == PictureKind::difference
                                                        ? encode_png(draw_difference(picture, result.expected), false)
                                                        : encode_picture(result.name, picture));
}

void write_kinds(PictureResult const& result, std::filesystem::path const& directory,
                 std::filesystem::path const& envelopes)
{
    std::filesystem::copy_file(envelopes / (result.name + ".png"),
                               directory / file_name(result, PictureKind::expected));
    for (auto kind : {PictureKind::isolated, PictureKind::submitted, PictureKind::difference})
        write_picture(result, kind, directory);
}
}  // namespace

std::optional<std::string> picture_file(PictureResult const& result, PictureKind kind)
{
    bool const made = rendering(result, kind) != nullptr;
    bool const shared = kind != PictureKind::difference && made && !has_own_file(result, kind);
    if (kind == PictureKind::expected || shared)
        return "pictures/" + file_name(result, PictureKind::expected);
    return has_own_file(result, kind) ? std::optional("pictures/" + file_name(result, kind)) : std::nullopt;
}

std::string encode_picture(std::string const& name, Picture const& picture)
{
    return encode_png(picture, name != miplevels);
}

Picture draw_difference(Picture const& submitted, Picture const& expected)
{
    Picture difference{expected.width, expected.height, {}};
    for (std::size_t i = 0; i < expected.rgb.size(); i += 3) {
        Rgb const colour = difference_of(&submitted.rgb[i], &expected.rgb[i]);
        difference.rgb.insert(difference.rgb.end(), {float(colour.r), float(colour.g), float(colour.b)});
    }
    return difference;
}

void write_pictures(CheckResults const& results, std::filesystem::path const& directory,
                    std::filesystem::path const& envelopes)
{
    auto const fresh = directory / "pictures.part";
    std::filesystem::remove_all(fresh);
    std::filesystem::create_directories(fresh);
    try {
        for (auto const& picture : results.pictures)
            write_kinds(picture, fresh, envelopes);
    } catch (...) {
        std::filesystem::remove_all(fresh);
        throw;
    }
    replace_directory(fresh, directory / "pictures");
}
}  // namespace testat
