#include "bench/truth_cache.h"

#include "bench/patterns.h"
#include "report/report.h"
#include "text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

namespace testat::bench {
namespace {
/// To be raised when truths are found in another way.
constexpr char version[] = "truth 1";

template <typename T>
std::string bytes_of(std::vector<T> const& values)
{
    static_assert(std::is_trivially_copyable_v<T>);
    return {reinterpret_cast<char const*>(values.data()), values.size() * sizeof(T)};
}

std::filesystem::path file_of(Scene const& scene, View const& view, Sheet const& sheet,
                              std::filesystem::path const& directory, int strata)
{
    std::ostringstream key;
    key << version << ' ' << scene.id << ' ' << view.side << ' ' << strata << ' ' << most_strata << ' ' << sheet.sha256
        << ' ' << bytes_of(view.footprints);
    return directory / (sha256(key.str()) + ".truth");
}

bool is_whole(Truth const& truth)
{
    return std::all_of(truth.begin(), truth.end(), [](glm::dvec3 const& c) {
        return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
    });
}

/// Empty if there is none of that size.
Truth read_truth(std::filesystem::path const& file, std::size_t pixels)
{
    std::ifstream in(file, std::ios::binary);
    std::string const bytes{std::istreambuf_iterator<char>(in), {}};
    if (bytes.size() != pixels * sizeof(glm::dvec3))
        return {};
    Truth truth(pixels);
    std::memcpy(truth.data(), bytes.data(), bytes.size());
    return is_whole(truth) ? truth : Truth();
}

/// A cache that cannot be written to is none; the truth is the same.
void keep(Truth const& truth, std::filesystem::path const& file)
{
    try {
        std::filesystem::create_directories(file.parent_path());
        write_atomically(file, bytes_of(truth));
    } catch (std::exception const&) {
        return;
    }
}
}  // namespace

std::vector<Sheet> make_sheets()
{
    std::vector<Sheet> sheets;
    for (auto const& pattern : patterns())
        for (int side : {256, 1024}) {
            TextureData texture = make_texture(pattern, side);
            std::string hash = sha256(bytes_of(texture.levels[0].texels));
            sheets.push_back({pattern.id, std::move(texture), std::move(hash)});
        }
    return sheets;
}

std::filesystem::path truth_directory()
{
    std::filesystem::path const below = std::filesystem::path("testat") / "bench";
    if (char const* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache == '/')
        return cache / below;
    if (char const* home = std::getenv("HOME"); home != nullptr && *home == '/')
        return std::filesystem::path(home) / ".cache" / below;
    return {};
}

std::vector<Truth> truth_of(Scene const& scene, View const& view, std::vector<Sheet> const& sheets,
                            std::filesystem::path const& directory, int strata)
{
    std::vector<Truth> truths(sheets.size());
    std::vector<TextureData> unknown;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        if (!directory.empty())
            truths[i] = read_truth(file_of(scene, view, sheets[i], directory, strata), view.pixels.size());
        if (truths[i].empty())
            unknown.push_back({sheets[i].texture.wrap_mode, {sheets[i].texture.levels[0]}});
    }
    if (unknown.empty())
        return truths;
    std::vector<Truth> found = find_truth(scene, view, unknown, strata);
    auto next = found.begin();
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        if (!truths[i].empty())
            continue;
        truths[i] = std::move(*next++);
        if (!directory.empty())
            keep(truths[i], file_of(scene, view, sheets[i], directory, strata));
    }
    return truths;
}
}  // namespace testat::bench
