#pragma once
#include "bench/truth.h"

/// Truths take long and never change: they are kept on disk, by the SHA-256 of all they depend on.
namespace testat::bench {
/// A texture and the SHA-256 of its level 0.
struct Sheet {
    std::string pattern;  ///< id
    TextureData texture;
    std::string sha256;

    int side() const { return texture.levels[0].width; }
};

/// All patterns in both sizes: 256 and 1024 texels to a side.
std::vector<Sheet> make_sheets();

/// testat/bench in $XDG_CACHE_HOME or ~/.cache; empty if there is neither.
std::filesystem::path truth_directory();

/// One truth for each sheet. Reads those that are in the directory and writes those that are not; where it cannot, or
/// where a file is damaged, they are found again. An empty directory keeps nothing.
std::vector<Truth> truth_of(Scene const& scene, View const& view, std::vector<Sheet> const& sheets,
                            std::filesystem::path const& directory, int strata = least_strata);
}  // namespace testat::bench
