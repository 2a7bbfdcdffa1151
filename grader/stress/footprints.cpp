#include "checks/shapes.h"
#include "stress/subjects.h"
#include "stress/wide_matrices.h"

#include <algorithm>

// compute_uv_aabb_size. Contract: unit frames; a hit up to 1e3 away from the shape's centre, seen from 1e-2 to 1e4 away
// under an angle with a cosine of 1e-4 or more (rays through corners may be exactly parallel to the tangent plane, or
// miss it); scale_uv from 1e-3 to 1e3.
namespace testat {
namespace {
constexpr double flattest_view = 1e-4;
/// The framework's order of the corners: (-,-) (+,+) (-,+) (+,-).
constexpr double corner_signs[4][2] = {{-1, -1}, {1, 1}, {-1, 1}, {1, -1}};

double any_scale(Random& random)
{
    return random.coin() ? pick(random, {0.5, 1.0, 2.0, 4.0, 10.0}) : log_uniform(random, 1e-3, 1e3);
}

FootprintQuestion on_plane(Random& random)
{
    FootprintQuestion q{};
    glm::dmat3 const frame(seldom(random, 3) ? glm::dmat4(1) : random_rotation(random));
    glm::dvec3 const center = seldom(random, 3) ? glm::dvec3(0) : random_vector(random, log_uniform(random, 1e-2, 1e3));
    q.shape = make_plane(center, frame[1], frame[0], any_scale(random));
    double const reach = log_uniform(random, 1e-3, 1e3);
    double const x = random.uniform(-reach, reach);
    store(dvec3(q.shape.center) + frame * glm::dvec3(x, 0, random.uniform(-reach, reach)), q.position);
    // Interpolated normals lean to the side.
    glm::dvec3 const normal = seldom(random, 4) ? glm::normalize(frame[1] + random_vector(random, 0.3)) : frame[1];
    store(normal, q.normal);
    store(frame[0], q.tangent);
    return q;
}

FootprintQuestion on_sphere(Random& random)
{
    FootprintQuestion q{};
    double const radius = log_uniform(random, 1e-2, 1e2);
    q.shape =
        make_sphere(seldom(random, 3) ? glm::dvec3(0) : random_vector(random, 10 * radius), radius, any_scale(random));
    glm::dvec3 const normal = any_direction(random);
    store(normal, q.normal);
    store(dvec3(q.shape.center) + radius * normal, q.position);
    store(glm::normalize(glm::cross(normal, random_direction(random))), q.tangent);
    return q;
}

/// Anything perpendicular to the normal.
glm::dvec3 side_of(Random& random, glm::dvec3 normal)
{
    return glm::normalize(glm::cross(normal, random_direction(random)));
}

/// A pixel: where it is seen from, and half its size.
void look_at(Random& random, FootprintQuestion& q)
{
    glm::dvec3 const normal = glm::normalize(dvec3(q.normal));
    glm::dvec3 const side = side_of(random, normal);
    double const cosine = random.coin() ? random.uniform(0.3, 1) : log_uniform(random, flattest_view, 1);
    glm::dvec3 const backward = cosine * normal + std::sqrt(1 - cosine * cosine) * side;
    glm::dvec3 const eye = dvec3(q.position) + backward * log_uniform(random, 1e-2, 1e4);
    double const half_pixel = log_uniform(random, 1e-5, 0.5);
    glm::dvec3 const right = half_pixel * side_of(random, backward);
    glm::dvec3 const up = glm::cross(backward, right);
    for (int i = 0; i < 4; ++i) {
        store(eye, q.origin[i]);
        store(glm::normalize(-backward + corner_signs[i][0] * right + corner_signs[i][1] * up), q.direction[i]);
    }
}

/// Some corners look away from the plane, or along it: exactly, where the normal is an axis.
void miss_some(Random& random, FootprintQuestion& q)
{
    int const first = random.integer(0, 3);
    int const count = random.integer(1, 4);
    for (int i = 0; i < count; ++i) {
        glm::dvec3 const normal = dvec3(q.normal);
        glm::dvec3 const side = side_of(random, normal);
        bool const along = glm::max(std::abs(normal.x), glm::max(std::abs(normal.y), std::abs(normal.z))) == 1;
        double const slope = seldom(random, along ? 2 : 16) ? 0 : random.uniform(0.01, 1);
        store(glm::normalize(side + slope * normal), q.direction[(first + i) % 4]);
    }
}

FootprintQuestion inside(Random& random)
{
    FootprintQuestion q = seldom(random, 4) ? on_sphere(random) : on_plane(random);
    store(glm::cross(dvec3(q.tangent), dvec3(q.normal)), q.bitangent);
    store(map_uv(q.shape, dvec3(q.position)), q.uv);
    look_at(random, q);
    if (seldom(random, 6))
        miss_some(random, q);
    return q;
}

/// Views so flat that t overflows, and numbers that are none.
FootprintQuestion outside(Random& random)
{
    FootprintQuestion q = inside(random);
    int const corner = random.integer(0, 3);
    switch (random.integer(0, 3)) {
        case 0:
            spoil(random, random.coin() ? q.origin[corner] : q.direction[corner], 3);
            return q;
        case 1:
            spoil(random, random.coin() ? q.position : q.normal, 3);
            return q;
        case 2:
            std::fill(std::begin(q.direction[corner]), std::end(q.direction[corner]),
                      pick(random, {0.f, denormal, 1e30f}));
            return q;
        default:
            store(glm::dvec3(0, 1, 0), q.normal);
            q.direction[corner][1] = pick(random, {denormal, -denormal, 1e-40f, -1e-38f});
            return q;
    }
}
}  // namespace

Block footprints_inside(Random& random, std::uint32_t questions)
{
    return make_block<FootprintQuestion>(Kind::footprint, random, questions, inside);
}

Block footprints_outside(Random& random, std::uint32_t questions)
{
    return make_block<FootprintQuestion>(Kind::footprint, random, questions, outside);
}
}  // namespace testat
