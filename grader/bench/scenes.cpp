#include "bench/scenes.h"

#include <cmath>

namespace testat::bench {
namespace {
constexpr double pi = 3.14159265358979323846;

Eye looking_along(glm::dvec3 position, glm::dvec3 direction)
{
    glm::dvec3 const backward = -glm::normalize(direction);
    glm::dvec3 const right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), backward));
    return {position, glm::dmat3(right, glm::cross(backward, right), backward)};
}

Eye looking_at(glm::dvec3 position, glm::dvec3 target)
{
    return looking_along(position, target - position);
}

/// The point with y = 0 that a ray meets.
std::optional<Hit> hit_ground(Ray const& ray)
{
    double const t = -ray.origin.y / ray.direction.y;
    if (!(t > 0 && t < HUGE_VAL))
        return std::nullopt;
    return Hit{ray.origin + t * ray.direction, {0, 1, 0}};
}

/// The nearest point of a ball around `center` that a ray from outside meets.
std::optional<Hit> hit_ball(Ray const& ray, glm::dvec3 center, double radius)
{
    glm::dvec3 const d = glm::normalize(ray.direction);
    glm::dvec3 const from = ray.origin - center;
    double const b = glm::dot(from, d);
    double const discriminant = b * b - glm::dot(from, from) + radius * radius;
    if (!(discriminant >= 0) || b > 0)
        return std::nullopt;
    glm::dvec3 const normal = (from + (-b - std::sqrt(discriminant)) * d) / radius;
    return Hit{center + radius * normal, glm::normalize(normal)};
}

/// The sheet's plane: ten units to a repetition. Turned around the point that the camera looks at.
Scene plane(std::string id, Title title, double degrees)
{
    double const c = std::cos(degrees * pi / 180);
    double const s = std::sin(degrees * pi / 180);
    Scene scene{std::move(id), title, looking_at({0, 7, 14.142135623730951}, {0, 0, 0}), hit_ground, {}};
    scene.uv = [=](glm::dvec3 const& p) {
        return glm::dvec2(0.5 + (c * p.x - s * -p.z) / 10, 0.5 + (s * p.x + c * -p.z) / 10);
    };
    return scene;
}

/// The sheet's ball: the texture five times around it and five times from pole to pole (SphericalMapping).
Scene sphere()
{
    constexpr double radius = 2;
    constexpr double scale_uv = 5;
    Scene scene{"sphere", {"Kugel", "sphere"}, looking_at({3, 4, 5}, {0, 0, 0}), {}, {}};
    scene.hit = [](Ray const& ray) { return hit_ball(ray, glm::dvec3(0), radius); };
    scene.uv = [](glm::dvec3 const& p) {
        glm::dvec3 const d = glm::normalize(p);
        double const turn = std::atan2(-d.z, d.x) / (2 * pi);
        return scale_uv * glm::dvec2(turn < 0 ? turn + 1 : turn, 1 - std::acos(glm::clamp(d.y, -1.0, 1.0)) / pi);
    };
    scene.period_u = scale_uv;
    return scene;
}

constexpr double board_side = 100;
constexpr double line_distance = 4.78515625;

/// Stones are balls half as high as wide. Every third crossing has one.
bool is_behind_a_stone(Ray const& ray)
{
    constexpr double radius = 2.3;
    glm::dvec3 const flat(1, 2, 1);
    for (int y = -9; y <= 9; ++y)
        for (int x = -9; x <= 9; ++x)
            if ((x + 2 * y) % 3 == 0 && hit_ball({flat * ray.origin, flat * ray.direction},
                                                 {x * line_distance, radius, y * line_distance}, radius))
                return true;
    return false;
}

/// The Go board through the sheet's camera: the texture once on the whole board.
Scene goboard()
{
    Scene scene{"goboard",
                {"Go-Brett", "goboard"},
                looking_along({44.24, 12.1067, 53.164}, {-0.513036, -0.309281, -0.800712}),
                {},
                {}};
    scene.hit = [](Ray const& ray) {
        auto const hit = hit_ground(ray);
        bool const on_board =
            hit && std::abs(hit->position.x) < board_side / 2 && std::abs(hit->position.z) < board_side / 2;
        return on_board ? hit : std::nullopt;
    };
    scene.uv = [](glm::dvec3 const& p) { return glm::dvec2(p.z, p.x) / board_side + 0.5; };
    scene.hidden = is_behind_a_stone;
    return scene;
}

/// The framework's order of a pixel's corners: (-,-) (+,+) (-,+) (+,-).
constexpr double corners[4][2] = {{0, 0}, {1, 1}, {0, 1}, {1, 0}};

/// From the centre of a footprint to one of its corners in uv space; nothing if the corner's ray misses the tangent
/// plane.
std::optional<glm::dvec2> offset_of(Scene const& scene, Hit const& centre, Ray const& corner)
{
    double const slope = glm::dot(corner.direction, centre.normal);
    double const t = glm::dot(centre.position - corner.origin, centre.normal) / slope;
    if (!(t > 0 && t < HUGE_VAL))
        return std::nullopt;
    glm::dvec2 offset = scene.uv(corner.origin + t * corner.direction) - scene.uv(centre.position);
    if (scene.period_u > 0)
        offset.x -= scene.period_u * std::round(offset.x / scene.period_u);
    return offset;
}

bool is_seen(Scene const& scene, Ray const& ray)
{
    return scene.hit(ray) && !scene.hidden(ray);
}

std::optional<Footprint> footprint_of(Scene const& scene, glm::ivec2 pixel, int side)
{
    Ray const through_centre = ray_through(scene.eye, glm::dvec2(pixel) + 0.5, side);
    auto const centre = scene.hit(through_centre);
    if (!centre || scene.hidden(through_centre))
        return std::nullopt;
    glm::dvec2 offsets[4];
    for (int i = 0; i < 4; ++i) {
        Ray const ray = ray_through(scene.eye, glm::dvec2(pixel) + glm::dvec2(corners[i][0], corners[i][1]), side);
        auto const offset = offset_of(scene, *centre, ray);
        if (!offset || !is_seen(scene, ray))
            return std::nullopt;
        offsets[i] = *offset;
    }
    auto const& o = offsets;
    return Footprint{
        scene.uv(centre->position), (o[1] - o[2] + o[3] - o[0]) / 2.0, (o[1] - o[3] + o[2] - o[0]) / 2.0,
        glm::max(glm::max(o[0], o[1]), glm::max(o[2], o[3])) - glm::min(glm::min(o[0], o[1]), glm::min(o[2], o[3]))};
}
}  // namespace

Ray ray_through(Eye const& eye, glm::dvec2 pixel, int side)
{
    glm::dvec3 const in_camera(pixel.x - side / 2.0, pixel.y - side / 2.0, -side);
    return {eye.position, eye.to_world * in_camera};
}

std::vector<Scene> const& scenes()
{
    static std::vector<Scene> const all = {
        plane("plane_0", {"Ebene 0°", "plane 0°"}, 0),
        plane("plane_30", {"Ebene 30°", "plane 30°"}, 30),
        plane("plane_45", {"Ebene 45°", "plane 45°"}, 45),
        sphere(),
        goboard(),
    };
    return all;
}

View look_at(Scene const& scene, int side)
{
    View view;
    view.side = side;
    for (int y = 0; y < side; y += tile)
        for (int x = 0; x < side; x += tile)
            for (int i = 0; i < tile * tile; ++i) {
                glm::ivec2 const pixel(x + i % tile, y + i / tile);
                if (auto const footprint = footprint_of(scene, pixel, side)) {
                    view.pixels.push_back(pixel);
                    view.footprints.push_back(*footprint);
                }
            }
    return view;
}
}  // namespace testat::bench
