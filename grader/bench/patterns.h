#pragma once
#include "bench/title.h"
#include "protocol/request.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

/// The textures of `testat bench`.
namespace testat::bench {
/// A picture by the colour of each point.
struct Pattern {
    std::string id;
    Title title;
    glm::dvec3 (*colour)(int x, int y, int side);  ///< linear rgb in [0, 1] of a texel
};

/// checker: 8 x 8 black and white fields, all edges; smooth: waves of up to three periods, no edges; noise: a colour of
/// its own for each texel.
std::vector<Pattern> const& patterns();

/// Repeated, `side` texels to a side (a power of two), with all mip levels: means of 2 x 2 texels, rounded once.
TextureData make_texture(Pattern const& pattern, int side);
}  // namespace testat::bench
