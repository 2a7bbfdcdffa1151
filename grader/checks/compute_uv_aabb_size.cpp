#include "checks/footprint_size.h"
#include "checks/matrices.h"
#include "checks/oracles.h"
#include "checks/relations.h"
#include "checks/shapes.h"

#include <fmt/format.h>

#include <algorithm>

namespace testat {
namespace {
constexpr int questions_each = 128;

/// A pixel: where it is seen from, and its axes (half a pixel long, relative to the distance).
struct View {
    glm::dvec3 eye;
    glm::dvec3 right;
    glm::dvec3 up;
};

/// The framework's order of the corners: (-,-) (+,+) (-,+) (+,-).
constexpr double corner_signs[4][2] = {{-1, -1}, {1, 1}, {-1, 1}, {1, -1}};

void set_corners(FootprintQuestion& q, View const& view)
{
    glm::dvec3 const forward = glm::normalize(dvec3(q.position) - view.eye);
    for (int i = 0; i < 4; ++i) {
        store(view.eye, q.origin[i]);
        store(glm::normalize(forward + corner_signs[i][0] * view.right + corner_signs[i][1] * view.up), q.direction[i]);
    }
}

FootprintQuestion make_question(Shape const& shape, glm::dvec3 position, glm::dvec3 normal, glm::dvec3 tangent)
{
    FootprintQuestion q{};
    q.shape = shape;
    store(position, q.position);
    store(normal, q.normal);
    store(tangent, q.tangent);
    store(glm::cross(tangent, normal), q.bitangent);
    store(map_uv(shape, position), q.uv);
    return q;
}

double random_scale_uv(Random& random)
{
    constexpr double scales[] = {0.5, 2, 4, 10};
    return scales[random.integer(0, 3)];
}

/// Straight from above, pixel edges along the texture's axes.
FootprintQuestion ask_axis_aligned(Random& random)
{
    Shape const plane = make_plane({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, random_scale_uv(random));
    glm::dvec3 const position(random.uniform(-20, 20), 0, random.uniform(-20, 20));
    FootprintQuestion q = make_question(plane, position, {0, 1, 0}, {1, 0, 0});
    double const width = random.uniform(0.01, 0.1);
    set_corners(q, {dvec3(q.position) + glm::dvec3(0, random.uniform(1, 10), 0),
                    {width, 0, 0},
                    {0, 0, -random.uniform(0.01, 0.1)}});
    return q;
}

/// A view onto `position`, tilted against the normal by an angle with a cosine in [lo, hi), and rolled.
View random_view(Random& random, glm::dvec3 position, glm::dvec3 normal, double lo, double hi, double half_pixel)
{
    glm::dvec3 side = glm::normalize(glm::cross(normal, random_direction(random)));
    double const cosine = random.uniform(lo, hi);
    glm::dvec3 const backward = cosine * normal + std::sqrt(1 - cosine * cosine) * side;
    glm::dvec3 const right = glm::normalize(glm::cross(normal, side));
    double const roll = random.uniform(0.3, 1.2);
    glm::dvec3 const up = glm::cross(backward, right);
    return {position + backward * random.uniform(2, 8), half_pixel * (std::cos(roll) * right + std::sin(roll) * up),
            half_pixel * (std::cos(roll) * up - std::sin(roll) * right)};
}

/// Moves where the rays start along the rays, each by another distance: what they meet stays the same.
void spread_origins(Random& random, FootprintQuestion& q)
{
    for (int i = 0; i < 4; ++i)
        store(dvec3(q.origin[i]) + random.uniform(-1, 1) * dvec3(q.direction[i]), q.origin[i]);
}

FootprintQuestion ask_rotated(Random& random)
{
    // Now and then at uv up to some thousand, on either side of zero: large pixels, as a float has few digits left, but
    // seen so that no corner misses.
    bool const far = random.integer(0, 15) == 0;
    double const reach = far ? 1500 : 9;
    double const half_pixel = far ? random.uniform(0.2, 0.4) : random.uniform(0.005, 0.05);
    glm::dmat3 const frame(random_rotation(random));
    Shape const plane = make_plane(random_vector(random, 3), frame[1], frame[0], far ? 0.5 : random_scale_uv(random));
    glm::dvec3 const position =
        dvec3(plane.center) + frame * glm::dvec3(random.uniform(-reach, reach), 0, random.uniform(-reach, reach));
    FootprintQuestion q = make_question(plane, position, frame[1], frame[0]);
    set_corners(q, random_view(random, position, frame[1], far ? 0.8 : 0.3, 1, half_pixel));
    spread_origins(random, q);
    return q;
}

/// Numbers that are exact in float, so that the uv of a corner that misses is the uv of the intersection to the last
/// bit.
FootprintQuestion ask_misses(Random& random)
{
    Shape const plane = make_plane({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, random.coin() ? 2 : 4);
    glm::dvec3 const position(random.integer(-20, 20), 0, random.integer(-20, 20));
    FootprintQuestion q = make_question(plane, position, {0, 1, 0}, {1, 0, 0});
    glm::dvec3 const eye = position + glm::dvec3(0, 2, 0);
    set_corners(q, {eye, {random.uniform(0.1, 0.5), 0, 0}, {0, 0, -random.uniform(0.1, 0.5)}});
    // The first corner only if all miss: from there, the differences to the others are still the size of the box,
    // which other checks look at.
    int const first = random.integer(0, 2);
    int const misses = random.integer(1, 4);
    for (int i = 0; i < misses; ++i) {  // upward, or exactly parallel
        glm::dvec3 const away(random.uniform(-1, 1), random.coin() ? 0.0 : random.uniform(0.1, 1), 1);
        store(glm::normalize(away), q.direction[i < 3 ? 1 + (first + i) % 3 : 0]);
    }
    return q;
}

/// A plane whose normal at the hit leans to the side, as interpolated normals do: the tangent plane is another one. The
/// corners lie on it so that their uv are a rectangle along u and v.
FootprintQuestion ask_tangent_plane(Random& random)
{
    glm::dmat3 const frame(random_rotation(random));
    Shape const plane = make_plane(random_vector(random, 3), frame[1], frame[0], random_scale_uv(random));
    glm::dvec3 const position =
        dvec3(plane.center) + frame * glm::dvec3(random.uniform(-9, 9), 0, random.uniform(-9, 9));
    double const side = random.coin() ? 1 : -1;
    glm::dvec3 const lean(side * random.uniform(0.2, 0.5), 1, random.uniform(0.2, 0.5));
    FootprintQuestion q = make_question(plane, position, glm::normalize(frame * lean), frame[0]);
    // Along the tangent plane, one unit in u or in v goes up or down by the slope.
    glm::dvec3 const along_u = frame * glm::dvec3(1, -lean.x, 0);
    glm::dvec3 const along_v = frame * glm::dvec3(0, -lean.z, 1);
    double const width = random.uniform(0.05, 0.2);
    double const height = random.uniform(0.05, 0.2);
    glm::dvec3 const eye =
        position + frame * glm::dvec3(random.uniform(-1, 1), random.uniform(2, 8), random.uniform(-1, 1));
    for (int i = 0; i < 4; ++i) {
        glm::dvec3 const corner =
            position + corner_signs[i][0] * width * along_u + corner_signs[i][1] * height * along_v;
        store(eye, q.origin[i]);
        store(glm::normalize(corner - eye), q.direction[i]);
    }
    return q;
}

auto ask(FootprintQuestion (*make)(Random&))
{
    return [=](Random& random, Textures const&) {
        std::vector<FootprintQuestion> questions;
        for (int i = 0; i < questions_each; ++i)
            questions.push_back(make(random));
        return make_group(Kind::footprint, questions);
    };
}

glm::dvec2 size_error(FootprintQuestion const& q)
{
    return footprint(q, {}).bound;
}

/// Two pixels seen from one height, and one as wide and high as both together in the same scene twice or half as large,
/// at another place and with a texture of another size.
struct ScaledScene {
    std::array<FootprintQuestion, 3> questions;
    double factor;  ///< from the sum of the first two answers to the third
};

FootprintQuestion ask_from_above(glm::dvec3 position, double scale_uv, double height, glm::dvec2 half_pixel)
{
    Shape const plane = make_plane({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, scale_uv);
    FootprintQuestion q = make_question(plane, position, {0, 1, 0}, {1, 0, 0});
    set_corners(q, {dvec3(q.position) + glm::dvec3(0, height, 0), {half_pixel.x, 0, 0}, {0, 0, -half_pixel.y}});
    return q;
}

ScaledScene scale_scene(Random& random, Textures const&)
{
    auto const place = [&] { return glm::dvec3(random.uniform(-20, 20), 0, random.uniform(-20, 20)); };
    auto const pixel = [&] { return glm::dvec2(random.uniform(0.01, 0.05), random.uniform(0.01, 0.05)); };
    double const scale_uv = random_scale_uv(random);
    double const other_scale_uv = random_scale_uv(random);
    double const scale = random.coin() ? 2 : 0.5;
    double const height = random.uniform(2, 5);
    glm::dvec2 const a = pixel();
    glm::dvec2 const b = pixel();
    glm::dvec3 const seen = place();
    return {{ask_from_above(seen, scale_uv, height, a), ask_from_above(seen, scale_uv, height, b),
             ask_from_above(place(), other_scale_uv, scale * height, a + b)},
            scale * scale_uv / other_scale_uv};
}

Deviation compare_sum(Answers const& answers, ScaledScene const& relation, std::array<std::uint32_t, 3> const& places)
{
    auto const& q = relation.questions;
    auto const size = [&](std::size_t i) { return glm::dvec2(dvec2(floats<2>(answers, places[i]).data())); };
    glm::dvec2 const right = relation.factor * (size(0) + size(1));
    glm::dvec2 const bound = relation.factor * (size_error(q[0]) + size_error(q[1])) + size_error(q[2]);
    Deviation d = compare({size(2).x, size(2).y}, {right.x, right.y}, {bound.x, bound.y});
    d.measured = fmt::format("f(A) = {}, f(B) = {}, f(C) = {}", format_vector({size(0).x, size(0).y}),
                             format_vector({size(1).x, size(1).y}), d.measured);
    d.expected = fmt::format("f(C) = {} * (f(A) + f(B)) = {}", relation.factor, d.expected);
    return d;
}

}  // namespace

Deviation footprint_deviation(Answers const& answers, std::uint32_t index, Textures const&, Words words)
{
    auto const measured = floats<2>(answers, index);
    Footprint const right = footprint(question<FootprintQuestion>(answers.group, index), dvec2(measured.data()));
    Deviation deviation = compare({measured.begin(), measured.end()}, {right.size.x, right.size.y},
                                  {right.bound.x, right.bound.y}, words);
    deviation.decided = right.decided;
    return deviation;
}

void add_compute_uv_aabb_size_checks(std::vector<UnitCheck>& checks)
{
    auto const add = [&](char const* name, auto make) {
        checks.push_back({std::string("ComputeUvAabbSize.") + name, Function::compute_uv_aabb_size, ask(make),
                          judge_by(footprint_deviation)});
    };
    add("AxisAligned", ask_axis_aligned);
    add("Rotated", ask_rotated);
    add("RaysThatMiss", ask_misses);
    add("TangentPlane", ask_tangent_plane);
    checks.push_back(metamorphic_check("ComputeUvAabbSize.ScaledScene", Function::compute_uv_aabb_size, Kind::footprint,
                                       scale_scene, compare_sum));
}
}  // namespace testat
