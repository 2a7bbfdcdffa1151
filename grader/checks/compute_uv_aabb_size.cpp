#include "checks/check.h"
#include "checks/matrices.h"
#include "checks/shapes.h"

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
    glm::dmat3 const frame(random_rotation(random));
    Shape const plane = make_plane(random_vector(random, 3), frame[1], frame[0], random_scale_uv(random));
    glm::dvec3 const position =
        dvec3(plane.center) + frame * glm::dvec3(random.uniform(-9, 9), 0, random.uniform(-9, 9));
    FootprintQuestion q = make_question(plane, position, frame[1], frame[0]);
    set_corners(q, random_view(random, position, frame[1], 0.3, 1, random.uniform(0.005, 0.05)));
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

/// A corner in uv, relative to the intersection's uv, with what float may be off by.
struct Corner {
    glm::dvec2 offset;
    glm::dvec2 error;
};

/// uv at the position, and how much it changes when the position is off by `error` in any direction.
Corner map_corner(FootprintQuestion const& q, glm::dvec3 position, double error)
{
    glm::dvec2 const uv = map_uv(q.shape, position);
    glm::dvec2 change(8 * eps * (glm::abs(uv) + 1.0));
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 moved = position;
        moved[axis] += error;
        change += glm::abs(map_uv(q.shape, moved) - uv);
    }
    return {uv - dvec2(q.uv), change};
}

/// t is a quotient: both dot products are sums of products of coordinates, the divisor is the cosine of the view.
Corner corner(FootprintQuestion const& q, int i)
{
    Line const ray{dvec3(q.origin[i]), glm::normalize(dvec3(q.direction[i]))};
    glm::dvec3 const position = dvec3(q.position);
    glm::dvec3 const normal = dvec3(q.normal);
    auto const t = meet_plane(position, normal, ray);
    if (!t)
        return map_corner(q, position, 4 * eps * glm::length(position));
    double const cosine = std::abs(glm::dot(ray.direction, normal));
    double const reach = glm::length(ray.origin) + glm::length(position) + *t + glm::length(dvec3(q.shape.center));
    return map_corner(q, ray.origin + *t * ray.direction, 8 * eps * reach * (1 + 1 / cosine));
}

/// The framework's rule at a seam: where both offsets of a pair point the same way, the longer one is replaced by the
/// mirrored shorter one.
void mend_seam(Corner& a, Corner& b)
{
    for (int axis = 0; axis < 2; ++axis) {
        if (!(a.offset[axis] * b.offset[axis] > 0))
            continue;
        bool const a_longer = std::abs(a.offset[axis]) > std::abs(b.offset[axis]);
        (a_longer ? a : b).offset[axis] = -(a_longer ? b : a).offset[axis];
    }
}

Verdict judge(Answers const& answers, Textures const&)
{
    return judge_each<FootprintQuestion>(answers, [&](FootprintQuestion const& q, std::uint32_t i) {
        Corner corners[4] = {corner(q, 0), corner(q, 1), corner(q, 2), corner(q, 3)};
        mend_seam(corners[0], corners[1]);
        mend_seam(corners[2], corners[3]);
        glm::dvec2 lower = corners[0].offset, upper = lower, error = corners[0].error;
        for (auto const& c : corners) {
            lower = glm::min(lower, c.offset);
            upper = glm::max(upper, c.offset);
            error = glm::max(error, c.error);
        }
        glm::dvec2 const right = upper - lower;
        auto const measured = floats<2>(answers, i);
        return compare({measured.begin(), measured.end()}, {right.x, right.y}, {2 * error.x, 2 * error.y});
    });
}
}  // namespace

void add_compute_uv_aabb_size_checks(std::vector<UnitCheck>& checks)
{
    auto const add = [&](char const* name, auto make) {
        checks.push_back({std::string("ComputeUvAabbSize.") + name, Function::compute_uv_aabb_size, ask(make), judge});
    };
    add("AxisAligned", ask_axis_aligned);
    add("Rotated", ask_rotated);
    add("RaysThatMiss", ask_misses);
    add("TangentPlane", ask_tangent_plane);
}
}  // namespace testat
