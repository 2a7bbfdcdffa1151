#pragma once
#include "bench/footprint.h"
#include "bench/title.h"

#include <functional>
#include <optional>
#include <string>

/// What `testat bench` looks at. Everything in double; no renderer of the framework takes part.
namespace testat::bench {
/// A pinhole camera as the framework's (cglib/core/camera.h), with a field of view of 45 degrees by its measure.
struct Eye {
    glm::dvec3 position{0};
    glm::dmat3 to_world{1};  ///< columns: right, up and backward, orthonormal
};

struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction;  ///< any length above 0
};

struct Hit {
    glm::dvec3 position;
    glm::dvec3 normal;  ///< unit
};

/// One textured surface, seen by a camera.
struct Scene {
    std::string id;
    Title title;
    Eye eye;
    std::function<std::optional<Hit>(Ray const&)> hit;  ///< where a ray meets the textured surface
    std::function<glm::dvec2(glm::dvec3 const&)> uv;    ///< texture coordinates of a point on it or near to it
    std::function<bool(Ray const&)> hidden = [](Ray const&) { return false; };  ///< by something in front of it
    double period_u = 0;  ///< u jumps by so much at a seam; 0: nowhere
};

/// In a square picture with `side` pixels to a side.
Ray ray_through(Eye const& eye, glm::dvec2 pixel, int side);

/// The plane of the sheet, which reaches to the horizon, its texture turned by 0, 30 and 45 degrees against the
/// direction of view; the sheet's ball; the Go board with stones on it.
std::vector<Scene> const& scenes();

/// Pixels to a side of a tile.
constexpr int tile = 8;

/// The pixels of a picture in which the textured surface is all that can be seen.
struct View {
    int side = 0;
    std::vector<glm::ivec2> pixels;  ///< column and row, from the lower left; tile by tile, as renderers go
    Footprints footprints;           ///< one for each pixel
};

/// Corners meet the tangent plane at the centre's hit, as on the sheet. Pixels that see the end of the surface, or
/// whose corners miss the tangent plane, are left out. `side`: a multiple of a tile's.
View look_at(Scene const& scene, int side);
}  // namespace testat::bench
